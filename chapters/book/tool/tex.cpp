#include "book/tool/tex.hpp"

#include <cctype>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

namespace tumble::book {

namespace {

std::set<std::string> set_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// The commands that the book may use: all known to KaTeX 0.16 and to GitHub's MathJax 3.
const std::set<std::string> known_commands = set_of(R"(
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

const std::set<std::string> known_environments = set_of(R"(
aligned array bmatrix cases gathered matrix pmatrix smallmatrix split vmatrix
)");

const std::set<std::string> with_one_argument = set_of(R"(
bar boldsymbol boxed cancel ddot dot hat hspace left mathbb mathbf mathcal mathit mathrm mathsf
operatorname overbrace overline phantom right sqrt substack tag text tilde underbrace underline vec
widehat xrightarrow
)");

const std::set<std::string> with_two_arguments = set_of("binom dfrac frac stackrel tfrac");

class Formula {
 public:
  explicit Formula(const std::string& tex) : tex_(tex) {}

  std::string mistake() {
    if (std::string what = mistake_of_braces(); !what.empty()) return what;
    while (at_ < tex_.size())
      if (std::string what = take_next(); !what.empty()) return what;
    if (lefts_ != 0) return "a \\left without a \\right";
    return open_.empty() ? "" : "\\begin{" + open_.back() + "} is not closed";
  }

 private:
  std::string mistake_of_braces() const {
    int depth = 0;
    for (std::size_t i = 0; i < tex_.size(); ++i) {
      if (tex_[i] == '\\') {
        ++i;  // an escaped brace is a sign
        continue;
      }
      if (tex_[i] == '{') ++depth;
      if (tex_[i] == '}' && --depth < 0) return "a } without a {";
    }
    return depth == 0 ? "" : "a { without a }";
  }

  std::string take_next() {
    const char c = tex_[at_];
    if (c == '\\') return take_command();
    if (c == '&' && open_.empty()) return "an & outside of an environment";
    if (c == '^' || c == '_') {
      if (std::string what = mistake_of_scripts(); !what.empty()) return what;
    }
    ++at_;
    return {};
  }

  std::string take_command() {
    const std::string command = word_at(at_ + 1);
    at_ += 1 + command.size();
    if (command.empty()) {
      ++at_;  // a blank, a brace, a new line
      return {};
    }
    if (!known_commands.contains(command)) return "unknown command \\" + command;
    const int wanted = with_two_arguments.contains(command)  ? 2
                       : with_one_argument.contains(command) ? 1
                                                             : 0;
    if (!has_arguments(wanted)) return "\\" + command + " lacks its argument";
    if (command == "left") ++lefts_;
    if (command == "right" && --lefts_ < 0) return "a \\right without a \\left";
    if (command == "begin" || command == "end") return take_border(command == "begin");
    return {};
  }

  std::string take_border(bool begins) {
    const auto close = tex_.find('}', at_);
    if (at_ >= tex_.size() || tex_[at_] != '{' || close == std::string::npos)
      return "an environment without a name";
    const std::string environment = tex_.substr(at_ + 1, close - at_ - 1);
    at_ = close + 1;
    if (!known_environments.contains(environment)) return "unknown environment " + environment;
    if (begins) {
      open_.push_back(environment);
      return {};
    }
    if (open_.empty() || open_.back() != environment)
      return "\\end{" + environment + "} without its \\begin";
    open_.pop_back();
    return {};
  }

  /// x^a_b is sound, x^a^b and x^ are not.
  std::string mistake_of_scripts() const {
    const char first = tex_[at_];
    const std::size_t behind = after_argument(at_ + 1);
    if (behind == std::string::npos) return std::string(1, first) + " without anything behind it";
    const std::size_t next = after_blanks(behind);
    if (next >= tex_.size()) return {};
    if (tex_[next] == first) return "two " + std::string(1, first) + " at one base";
    return {};
  }

  bool has_arguments(int count) const {
    std::size_t at = after_blanks(at_);
    if (count > 0 && at < tex_.size() && tex_[at] == '[' && word_before(at) == "sqrt")
      at = tex_.find(']', at) + 1;  // \sqrt[3]{x}
    for (; count > 0; --count) {
      at = after_argument(at);
      if (at == std::string::npos) return false;
    }
    return true;
  }

  /// Behind the argument at this place: {…}, a command, or one character; npos if there is none.
  std::size_t after_argument(std::size_t at) const {
    at = after_blanks(at);
    if (at >= tex_.size() || tex_[at] == '}' || tex_[at] == '&') return std::string::npos;
    if (tex_[at] == '\\') {
      const std::string command = word_at(at + 1);
      return at + 1 + (command.empty() ? 1 : command.size());
    }
    if (tex_[at] != '{') return at + 1;
    int depth = 0;
    for (; at < tex_.size(); ++at) {
      if (tex_[at] == '\\') {
        ++at;
      } else if (tex_[at] == '{') {
        ++depth;
      } else if (tex_[at] == '}' && --depth == 0) {
        return at + 1;
      }
    }
    return tex_.size();
  }

  std::size_t after_blanks(std::size_t at) const {
    while (at < tex_.size() && std::isspace(static_cast<unsigned char>(tex_[at])) != 0) ++at;
    return at;
  }

  std::string word_at(std::size_t at) const {
    std::string word;
    for (; at < tex_.size() && std::isalpha(static_cast<unsigned char>(tex_[at])) != 0; ++at)
      word += tex_[at];
    return word;
  }

  std::string word_before(std::size_t at) const {
    std::size_t from = at;
    while (from > 0 && std::isalpha(static_cast<unsigned char>(tex_[from - 1])) != 0) --from;
    return tex_.substr(from, at - from);
  }

  const std::string& tex_;
  std::size_t at_ = 0;
  int lefts_ = 0;
  std::vector<std::string> open_;
};

}  // namespace

std::string mistake_in(const std::string& tex) { return Formula(tex).mistake(); }

}  // namespace tumble::book
