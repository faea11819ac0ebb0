#include "judge/course/dashes.hpp"

namespace tumble::judge {

std::string with_hyphens(std::string text) {
  for (const std::string dash :
       {"\u2010", "\u2011", "\u2012", "\u2013", "\u2014", "\u2015", "\u2212"})
    for (std::size_t at; (at = text.find(dash)) != std::string::npos;)
      text.replace(at, dash.size(), "-");
  return text;
}

}  // namespace tumble::judge
