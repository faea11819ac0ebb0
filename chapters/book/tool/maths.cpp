#include "book/tool/maths.hpp"

#include <cctype>
#include <iterator>
#include <set>
#include <sstream>

namespace tumble::book {

std::vector<InlineFormula> formulas_in(const std::string& line) {
  std::vector<InlineFormula> formulas;
  bool in_code = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '`') in_code = !in_code;
    if (line[i] == '\\' && !in_code) ++i;
    if (in_code || i >= line.size() || line[i] != '$' || i + 1 >= line.size()) continue;
    const bool quoted = line[i + 1] == '`';
    if (line[i + 1] == ' ') continue;
    const std::string closing = quoted ? "`$" : "$";
    const auto end = line.find(closing, i + closing.size());
    if (end == std::string::npos) continue;
    if (!quoted &&
        (line[end - 1] == ' ' ||
         (end + 1 < line.size() && std::isdigit(static_cast<unsigned char>(line[end + 1])))))
      continue;
    const std::size_t start = i + closing.size();
    formulas.push_back({i, end + closing.size(), line.substr(start, end - start)});
    i = end + closing.size() - 1;
  }
  return formulas;
}

namespace {

std::set<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// The commands that the book may use: all known to KaTeX 0.16 and to GitHub's MathJax 3.
const std::set<std::string> known_commands = words_of(R"(
alpha angle approx arccos arcsin arctan ast bar because begin beta big Big Bigg biggl biggr bigl
Bigl Bigr bigr binom boldsymbol boxed cancel cap cdot cdots chi circ colon color cong cos cup
dagger ddot ddots Delta delta det dfrac displaystyle dot dots ell end epsilon equiv eta exists
exp forall frac gamma Gamma ge geq gg hat hline hspace iff iiint iint Im implies in infty int
intercal kappa lambda Lambda land langle lceil ldots le left leftarrow leq lfloor lim limits ll
ln log longrightarrow lor lVert lvert mapsto mathbb mathbf mathcal mathit mathrm mathsf max mid
min mp mu nabla ne neg neq nolimits not notin nu oint Omega omega operatorname oplus otimes
overbrace overline parallel partial perp phantom Phi phi pi pm prec prime prod propto Psi psi
qquad quad rangle rceil Re rfloor rho right Rightarrow rightarrow rVert rvert Sigma sigma sim
simeq sin sqrt stackrel star subset substack succ sum tag tan tau text textstyle tfrac therefore
Theta theta tilde times to top triangleq underbrace underline varepsilon varphi vdots vec Vert
vert widehat xi xrightarrow zeta
)");

const std::set<std::string> known_environments = words_of(R"(
aligned array bmatrix cases gathered matrix pmatrix smallmatrix split vmatrix
)");

std::string word_at(const std::string& tex, std::size_t at) {
  std::string word;
  for (; at < tex.size() && std::isalpha(static_cast<unsigned char>(tex[at])); ++at)
    word += tex[at];
  return word;
}

std::string braced_at(const std::string& tex, std::size_t at) {
  if (at >= tex.size() || tex[at] != '{') return {};
  return tex.substr(at + 1, tex.find('}', at) - at - 1);
}

}  // namespace

std::string mistake_in(const std::string& tex) {
  int braces = 0, lefts = 0;
  std::vector<std::string> open;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    if (tex[i] == '{') ++braces;
    if (tex[i] == '}' && --braces < 0) return "a } without a {";
    if (tex[i] != '\\') continue;
    const std::string command = word_at(tex, i + 1);
    if (command.empty()) {
      ++i;  // \, \{ \\ and the like
      continue;
    }
    i += command.size();
    if (!known_commands.contains(command)) return "unknown command \\" + command;
    const std::string environment = braced_at(tex, i + 1);
    if (command == "begin" && !known_environments.contains(environment))
      return "unknown environment " + environment;
    if (command == "begin") open.push_back(environment);
    if (command == "end" && (open.empty() || open.back() != environment))
      return "\\end{" + environment + "} without its \\begin";
    if (command == "end") open.pop_back();
    if (command == "left") ++lefts;
    if (command == "right" && --lefts < 0) return "a \\right without a \\left";
  }
  if (braces != 0) return "a { without a }";
  if (lefts != 0) return "a \\left without a \\right";
  return open.empty() ? "" : "\\begin{" + open.back() + "} is not closed";
}

std::string markdown_trap_in(const std::string& tex) {
  const auto is_punctuation = [&tex](std::size_t i) {
    return std::ispunct(static_cast<unsigned char>(tex[i])) != 0;
  };
  for (std::size_t i = 0; i + 1 < tex.size(); ++i) {
    if (tex[i] == '\\' && is_punctuation(i + 1)) return tex.substr(i, 2);  // an escape
    if (tex[i + 1] == '_' && is_punctuation(i)) return tex.substr(i, 2);   // emphasis
    if (tex[i] == '*') return "*";
  }
  return {};
}

}  // namespace tumble::book
