#include "model/text/wildcard.h"

namespace model {

bool fitsWildcard(std::string_view name, std::string_view pattern) {
    return fitsWildcard(name, pattern, [](char a, char b) { return a == b; });
}

bool fitsWildcard(std::string_view name, std::string_view pattern, bool (*isAlike)(char, char)) {
    // The last star seen takes more and more of the name until what follows it fits.
    std::size_t at = 0;
    std::size_t p = 0;
    std::size_t star = std::string_view::npos;
    std::size_t afterStar = 0;
    while (at < name.size()) {
        if (p < pattern.size() && (pattern[p] == '?' || (pattern[p] != '*' && isAlike(name[at], pattern[p])))) {
            ++at;
            ++p;
        } else if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            afterStar = at;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            at = ++afterStar;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace model
