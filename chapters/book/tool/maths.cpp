#include "book/tool/maths.hpp"

#include <cctype>
#include <set>

namespace tumble::book {

std::vector<InlineFormula> formulas_in(const std::string& line) {
  std::vector<InlineFormula> formulas;
  bool in_code = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '`') in_code = !in_code;
    if (line[i] == '\\') ++i;
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

/// The commands that the book uses: all known to KaTeX 0.16 and to GitHub's MathJax 3.
const std::set<std::string>& known_commands() {
  static const std::set<std::string> known{"alpha",
                                           "beta",
                                           "gamma",
                                           "delta",
                                           "epsilon",
                                           "varepsilon",
                                           "zeta",
                                           "eta",
                                           "theta",
                                           "kappa",
                                           "lambda",
                                           "mu",
                                           "nu",
                                           "xi",
                                           "pi",
                                           "rho",
                                           "sigma",
                                           "tau",
                                           "phi",
                                           "varphi",
                                           "chi",
                                           "psi",
                                           "omega",
                                           "Gamma",
                                           "Delta",
                                           "Theta",
                                           "Lambda",
                                           "Sigma",
                                           "Phi",
                                           "Psi",
                                           "Omega",
                                           "times",
                                           "cdot",
                                           "cdots",
                                           "ldots",
                                           "dots",
                                           "vdots",
                                           "ddots",
                                           "pm",
                                           "mp",
                                           "le",
                                           "leq",
                                           "ge",
                                           "geq",
                                           "ll",
                                           "gg",
                                           "ne",
                                           "neq",
                                           "approx",
                                           "equiv",
                                           "sim",
                                           "propto",
                                           "perp",
                                           "parallel",
                                           "in",
                                           "notin",
                                           "subset",
                                           "to",
                                           "mapsto",
                                           "rightarrow",
                                           "Rightarrow",
                                           "leftarrow",
                                           "iff",
                                           "implies",
                                           "infty",
                                           "partial",
                                           "nabla",
                                           "forall",
                                           "exists",
                                           "sum",
                                           "prod",
                                           "int",
                                           "iint",
                                           "iiint",
                                           "oint",
                                           "lim",
                                           "max",
                                           "min",
                                           "sin",
                                           "cos",
                                           "tan",
                                           "arcsin",
                                           "arccos",
                                           "arctan",
                                           "exp",
                                           "log",
                                           "ln",
                                           "det",
                                           "frac",
                                           "tfrac",
                                           "dfrac",
                                           "sqrt",
                                           "dot",
                                           "ddot",
                                           "hat",
                                           "bar",
                                           "vec",
                                           "tilde",
                                           "widehat",
                                           "overline",
                                           "underline",
                                           "mathbf",
                                           "mathbb",
                                           "mathrm",
                                           "mathcal",
                                           "mathsf",
                                           "boldsymbol",
                                           "text",
                                           "operatorname",
                                           "left",
                                           "right",
                                           "big",
                                           "Big",
                                           "bigl",
                                           "bigr",
                                           "Bigl",
                                           "Bigr",
                                           "langle",
                                           "rangle",
                                           "lvert",
                                           "rvert",
                                           "lVert",
                                           "rVert",
                                           "vert",
                                           "Vert",
                                           "lfloor",
                                           "rfloor",
                                           "lceil",
                                           "rceil",
                                           "quad",
                                           "qquad",
                                           "begin",
                                           "end",
                                           "top",
                                           "intercal",
                                           "circ",
                                           "prime",
                                           "star",
                                           "ast",
                                           "underbrace",
                                           "overbrace",
                                           "binom",
                                           "not",
                                           "mid",
                                           "cap",
                                           "cup",
                                           "land",
                                           "lor",
                                           "neg",
                                           "ell",
                                           "Re",
                                           "Im",
                                           "displaystyle",
                                           "textstyle",
                                           "limits",
                                           "nolimits",
                                           "hline",
                                           "otimes",
                                           "oplus",
                                           "simeq",
                                           "cong",
                                           "phantom",
                                           "hspace",
                                           "tag",
                                           "Bigg",
                                           "biggl",
                                           "biggr",
                                           "angle",
                                           "longrightarrow",
                                           "xrightarrow",
                                           "succ",
                                           "prec",
                                           "colon",
                                           "dagger",
                                           "triangleq",
                                           "because",
                                           "therefore",
                                           "quad",
                                           "mathit",
                                           "boxed",
                                           "cancel",
                                           "color",
                                           "substack",
                                           "stackrel"};
  return known;
}

const std::set<std::string>& known_environments() {
  static const std::set<std::string> known{"aligned", "matrix",     "pmatrix", "bmatrix",
                                           "vmatrix", "cases",      "array",   "gathered",
                                           "split",   "smallmatrix"};
  return known;
}

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
    if (!known_commands().contains(command)) return "unknown command \\" + command;
    const std::string environment = braced_at(tex, i + 1);
    if (command == "begin" && !known_environments().contains(environment))
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
