#include "tests/reference/symbols.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <vector>

namespace reference {

namespace {

constexpr double kPi = std::numbers::pi;

/// The numbers of a name as written, and the letter and corner list behind them.
struct Values {
    std::vector<double> n;
    double unit = 1.0;
    char letter = 0;  ///< r, c or s
    double extra = 0.0;
    std::string corners = "1234";

    /// A length in mm.
    [[nodiscard]] double operator()(std::size_t i) const { return i < n.size() ? n[i] * unit : 0.0; }
};

bool box(Point p, double w, double h) {
    return std::abs(p.x) <= w / 2 && std::abs(p.y) <= h / 2;
}

bool disc(Point p, double d) {
    return std::hypot(p.x, p.y) <= d / 2;
}

/// A box with some corners cut or rounded.
bool cornered(Point p, double w, double h, const Values& v, double radius, bool isRound) {
    if (!box(p, w, h)) {
        return false;
    }
    const double r = std::clamp(radius, 0.0, std::min(w, h) / 2);
    const char corner = p.y >= 0 ? (p.x >= 0 ? '1' : '2') : (p.x < 0 ? '3' : '4');
    const double dx = std::abs(p.x) - (w / 2 - r);
    const double dy = std::abs(p.y) - (h / 2 - r);
    if (v.corners.find(corner) == std::string::npos || dx <= 0 || dy <= 0) {
        return true;
    }
    return isRound ? std::hypot(dx, dy) <= r : dx + dy <= r;
}

bool oval(Point p, double w, double h) {
    const double r = std::min(w, h) / 2;
    const double dx = std::max(std::abs(p.x) - (w / 2 - r), 0.0);
    const double dy = std::max(std::abs(p.y) - (h / 2 - r), 0.0);
    return w > 0 && h > 0 && std::hypot(dx, dy) <= r;
}

/// Distance from the middle line of a gap, and whether the point lies on its side.
struct Along {
    double forward;
    double aside;
};
Along along(Point p, double degrees) {
    const double a = degrees * kPi / 180;
    return {p.x * std::cos(a) + p.y * std::sin(a), p.y * std::cos(a) - p.x * std::sin(a)};
}

/// In one of the gaps of a ring w × h? Diagonal gaps of rectangles start where they leave through the corner.
bool gap(Point p, double first, double count, double width, double w = 0, double h = 0) {
    for (int i = 0; i < std::lround(count); ++i) {
        const double degrees = first + 360.0 * i / count;
        Point q = p;
        if (std::lround(degrees / 45) % 2 != 0) {
            const double sx = std::cos(degrees * kPi / 180) > 0 ? 1 : -1;
            const double sy = std::sin(degrees * kPi / 180) > 0 ? 1 : -1;
            q = {p.x - sx * std::max(w - h, 0.0) / 2, p.y - sy * std::max(h - w, 0.0) / 2};
        }
        const Along at = along(q, degrees);
        if (at.forward >= 0 && std::abs(at.aside) <= width / 2) {
            return true;
        }
    }
    return false;
}

/// Distance from a point to the ring's middle line pieces: thr.
bool roundEnded(Point p, const Values& v) {
    const double middle = (v(0) + v(1)) / 4;
    const double r = (v(0) - v(1)) / 4;
    const double count = v.n[3];
    const double shift = std::asin((v(4) / 2 + r) / middle) * 180 / kPi;
    for (int i = 0; i < std::lround(count); ++i) {
        const double from = v.n[2] + 360.0 * i / count + shift;
        const double sweep = 360.0 / count - 2 * shift;
        double at = std::fmod(std::atan2(p.y, p.x) * 180 / kPi - from, 360.0);
        at = at < 0 ? at + 360 : at;
        const auto end = [&](double degrees) {
            const double a = degrees * kPi / 180;
            return std::hypot(p.x - middle * std::cos(a), p.y - middle * std::sin(a));
        };
        const double distance =
            at <= sweep ? std::abs(std::hypot(p.x, p.y) - middle) : std::min(end(from), end(from + sweep));
        if (distance <= r) {
            return true;
        }
    }
    return false;
}

/// Rings with open corners: square (s_tho) or rectangular, with diagonal or straight gaps.
bool openCorner(Point p, double w, double h, double line, double first, double count, double width) {
    if (!box(p, w, h) || (std::abs(p.x) < w / 2 - line && std::abs(p.y) < h / 2 - line)) {
        return false;
    }
    for (int i = 0; i < std::lround(count); ++i) {
        const double degrees = first + 360.0 * i / count;
        if (std::lround(degrees / 45) % 2 == 0) {
            const Along at = along(p, degrees);
            if (at.forward >= 0 && std::abs(at.aside) <= width / 2) {
                return false;
            }
            continue;
        }
        const double sx = std::cos(degrees * kPi / 180) > 0 ? 1 : -1;
        const double sy = std::sin(degrees * kPi / 180) > 0 ? 1 : -1;
        if (p.x * sx >= w / 2 - line - width / std::sqrt(2.0) && p.y * sy >= h / 2 - line - width / std::sqrt(2.0)) {
            return false;
        }
    }
    return true;
}

bool lineThermal(Point p, const Values& v) {
    const double line = (v(0) - v(1)) / 2;
    const double half = v(1) / 2 - v(4) / std::sqrt(2.0) - line / 2;
    const double middle = (v(0) + v(1)) / 4;
    const double a = std::hypot(std::max(std::abs(p.x) - half, 0.0), std::abs(p.y) - middle);
    const double b = std::hypot(std::abs(p.x) - middle, std::max(std::abs(p.y) - half, 0.0));
    return std::min(a, b) <= line / 2;
}

bool moire(Point p, const Values& v) {
    const double d = std::hypot(p.x, p.y);
    bool isInside = d <= v(0) / 2;
    for (int i = 1; i <= std::lround(v.n[2]); ++i) {
        const double inner = v(0) / 2 + i * v(1) + (i - 1) * v(0);
        isInside = isInside || (d >= inner && d <= inner + v(0));
    }
    for (const double degrees : {v.n[5], v.n[5] + 90}) {
        const Along at = along(p, degrees);
        isInside = isInside || std::hypot(std::max(std::abs(at.forward) - v(4) / 2, 0.0), at.aside) <= v(3) / 2;
    }
    return isInside;
}

double barMiddle(double percent, double size, double width) {
    return std::clamp(percent / 100 * size - size / 2, width / 2 - size / 2, size / 2 - width / 2);
}

bool bar(Point p, double x, double y, double w, double h, bool isRound) {
    const Point q{p.x - x, p.y - y};
    return isRound ? oval(q, w, h) : box(q, w, h);
}

bool padGrid(Point p, const Values& v) {
    const double w = (v(0) - v(2) * (v.n[4] - 1)) / v.n[4];
    const double h = (v(1) - v(3) * (v.n[5] - 1)) / v.n[5];
    const double x = std::fmod(p.x + v(0) / 2, w + v(2));
    const double y = std::fmod(p.y + v(1) / 2, h + v(3));
    return box(p, v(0), v(1)) && x <= w && y <= h;
}

using Inside = bool (*)(Point, const Values&);

bool hexagon(Point p, double w, double h, double cut) {
    return box(p, w, h) && (w / 2 - std::abs(p.x)) >= cut * std::abs(p.y) / (h / 2);
}

/// By family; values as the name lists them.
const std::map<std::string, Inside> kFamilies = {
    {"r", [](Point p, const Values& v) { return disc(p, v(0)); }},
    {"s", [](Point p, const Values& v) { return box(p, v(0), v(0)); }},
    {"rect",
     [](Point p, const Values& v) {
         return cornered(p, v(0), v(1), v, v.letter != 0 ? v.extra * v.unit : 0, v.letter == 'r');
     }},
    {"oval", [](Point p, const Values& v) { return oval(p, v(0), v(1)); }},
    {"di", [](Point p, const Values& v) { return std::abs(p.x) / v(0) + std::abs(p.y) / v(1) <= 0.5; }},
    {"oct", [](Point p, const Values& v) { return cornered(p, v(0), v(1), v, v(2), false); }},
    {"hex_l", [](Point p, const Values& v) { return hexagon(p, v(0), v(1), v(2)); }},
    {"hex_s",
     [](Point p, const Values& v) {
         return hexagon({p.y, p.x}, v(1), v(0), v(2));
     }},
    {"tri", [](Point p,
               const Values& v) { return box(p, v(0), v(1)) && std::abs(p.x) * 2 / v(0) <= (v(1) / 2 - p.y) / v(1); }},
    {"el", [](Point p, const Values& v) { return std::hypot(p.x / v(0), p.y / v(1)) <= 0.5; }},
    {"oval_h",
     [](Point p, const Values& v) {
         const double x = p.x - (v(0) - v(1)) / 2;
         return box(p, v(0), v(1)) && (x <= 0 || std::hypot(x, p.y) <= v(1) / 2);
     }},
    {"bfr", [](Point p, const Values& v) { return disc(p, v(0)) && p.x * p.y <= 0; }},
    {"bfs", [](Point p, const Values& v) { return box(p, v(0), v(0)) && p.x * p.y <= 0; }},
    {"donut_r", [](Point p, const Values& v) { return disc(p, v(0)) && !disc(p, v(1)); }},
    {"donut_s",
     [](Point p, const Values& v) {
         const double r = v.extra * v.unit;
         return cornered(p, v(0), v(0), v, r, true) && !cornered(p, v(1), v(1), v, r - (v(0) - v(1)) / 2, true);
     }},
    {"donut_sr", [](Point p, const Values& v) { return box(p, v(0), v(0)) && !disc(p, v(1)); }},
    {"donut_rc",
     [](Point p, const Values& v) {
         const double r = v.extra * v.unit;
         return cornered(p, v(0), v(1), v, r, true) &&
                !cornered(p, v(0) - 2 * v(2), v(1) - 2 * v(2), v, r - v(2), true);
     }},
    {"donut_o",
     [](Point p, const Values& v) { return oval(p, v(0), v(1)) && !oval(p, v(0) - 2 * v(2), v(1) - 2 * v(2)); }},
    {"thr", roundEnded},
    {"ths", [](Point p, const Values& v) { return disc(p, v(0)) && !disc(p, v(1)) && !gap(p, v.n[2], v.n[3], v(4)); }},
    {"s_ths",
     [](Point p, const Values& v) {
         const double r = v.extra * v.unit;
         return cornered(p, v(0), v(0), v, r, true) && !cornered(p, v(1), v(1), v, r - (v(0) - v(1)) / 2, true) &&
                !gap(p, v.n[2], v.n[3], v(4));
     }},
    {"s_tho",
     [](Point p, const Values& v) { return openCorner(p, v(0), v(0), (v(0) - v(1)) / 2, v.n[2], v.n[3], v(4)); }},
    {"s_thr", lineThermal},
    {"sr_ths",
     [](Point p, const Values& v) { return box(p, v(0), v(0)) && !disc(p, v(1)) && !gap(p, v.n[2], v.n[3], v(4)); }},
    {"rc_ths",
     [](Point p, const Values& v) {
         const double r = v.extra * v.unit;
         return cornered(p, v(0), v(1), v, r, true) &&
                !cornered(p, v(0) - 2 * v(5), v(1) - 2 * v(5), v, r - v(5), true) &&
                !gap(p, v.n[2], v.n[3], v(4), v(0), v(1));
     }},
    {"rc_tho", [](Point p, const Values& v) { return openCorner(p, v(0), v(1), v(5), v.n[2], v.n[3], v(4)); }},
    {"o_ths",
     [](Point p, const Values& v) {
         return oval(p, v(0), v(1)) && !oval(p, v(0) - 2 * v(5), v(1) - 2 * v(5)) && !gap(p, v.n[2], v.n[3], v(4));
     }},
    {"oblong_ths",
     [](Point p, const Values& v) {
         const bool isRound = v.letter == 'r';
         const double w = v(0) - 2 * v(5);
         const double h = v(1) - 2 * v(5);
         const bool isRing = isRound ? oval(p, v(0), v(1)) && !oval(p, w, h) : box(p, v(0), v(1)) && !box(p, w, h);
         return isRing && !gap(p, v.n[2], v.n[3], v(4), isRound ? 0 : v(0), isRound ? 0 : v(1));
     }},
    {"moire", moire},
    {"hplate",
     [](Point p, const Values& v) {
         return box(p, v(0), v(1)) && v(0) / 2 - p.x >= v(2) * std::abs(p.y) / (v(1) / 2);
     }},
    {"rhplate",
     [](Point p, const Values& v) {
         return box(p, v(0), v(1)) && v(0) / 2 - p.x >= v(2) * (1 - std::abs(p.y) / (v(1) / 2));
     }},
    {"fhplate",
     [](Point p, const Values& v) {
         const double dx = p.x - (v(0) / 2 - v(3));
         const double dy = std::abs(p.y) - (v(1) / 2 - v(2));
         return box(p, v(0), v(1)) && (dx <= 0 || dy <= 0 || dx / v(3) + dy / v(2) <= 1);
     }},
    {"radhplate",
     [](Point p, const Values& v) { return box(p, v(0), v(1)) && std::hypot(p.x - v(0) / 2, p.y) >= v(2) / 2; }},
    {"dshape",
     [](Point p, const Values& v) {
         const double r = (v(1) * v(1) / 4 + v(2) * v(2)) / (2 * v(2));
         return box(p, v(0), v(1)) && (p.x <= v(0) / 2 - v(2) || std::hypot(p.x - (v(0) / 2 - r), p.y) <= r);
     }},
    {"cross",
     [](Point p, const Values& v) {
         const bool isRound = v.letter == 'r';
         return bar(p, 0, barMiddle(v.n[5], v(1), v(2)), v(0), v(2), isRound) ||
                bar(p, barMiddle(v.n[4], v(0), v(3)), 0, v(3), v(1), isRound);
     }},
    {"dogbone",
     [](Point p, const Values& v) {
         const bool isRound = v.letter == 'r';
         const double y = (v(1) - v(2)) / 2;
         return bar(p, 0, y, v(0), v(2), isRound) || bar(p, 0, -y, v(0), v(2), isRound) ||
                bar(p, barMiddle(v.n[4], v(0), v(3)), 0, v(3), v(1) - v(2), false);
     }},
    {"dpack", padGrid},
};

}  // namespace

std::optional<Symbol> standardSymbol(const std::string& name, double unit) {
    static const std::regex grammar(R"(([a-z_]+?)(-?[0-9.]+(?:x-?[0-9.]+)*)(?:x([rcs])([0-9.]*)(?:x([1-4]+))?)?)");
    std::smatch match;
    if (!std::regex_match(name, match, grammar) || !kFamilies.contains(match[1])) {
        return std::nullopt;
    }
    Values v;
    v.unit = unit;
    std::string list = match[2];
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = std::min(list.find('x', at), list.size());
        v.n.push_back(std::stod(list.substr(at, end - at)));
        at = end + 1;
    }
    v.letter = match[3].matched ? match[3].str()[0] : '\0';
    v.extra = match[4].length() > 0 ? std::stod(match[4]) : 0.0;
    v.corners = match[5].matched ? match[5].str() : v.corners;
    Symbol symbol;
    const Inside inside = kFamilies.at(match[1]);
    symbol.isInside = [inside, v](Point p) { return inside(p, v); };
    for (const double value : v.n) {
        symbol.reach = std::max(symbol.reach, std::abs(value) * unit);
    }
    symbol.penWidth = match[1] == "r" ? v(0) : 0.0;
    return symbol;
}

}  // namespace reference
