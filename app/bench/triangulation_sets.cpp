#include "app/bench/triangulation_sets.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace tri::bench {

namespace {

using Loop = std::vector<Point>;

constexpr double kPitch = 1e6;  // 1 mm between holes

Point at(double x, double y) {
    return {static_cast<base::Nm>(std::lround(x)), static_cast<base::Nm>(std::lround(y))};
}

/// Appends `corners` + 1 points of an arc from one angle to another (radians).
void arc(Loop& loop, double x, double y, double radius, double from, double to, int corners) {
    for (int i = 0; i <= corners; ++i) {
        const double angle = from + (to - from) * i / corners;
        loop.push_back(at(x + radius * std::cos(angle), y + radius * std::sin(angle)));
    }
}

Loop circle(double x, double y, double radius, int corners) {
    Loop loop;
    arc(loop, x, y, radius, 0, 2 * M_PI * (corners - 1) / corners, corners - 1);
    return loop;
}

/// A quarter of a ring, but for the spokes.
Loop slot(double x, double y, double inner, double outer, double from) {
    constexpr double kSpoke = 0.2;
    Loop loop;
    arc(loop, x, y, outer, from + kSpoke, from + M_PI / 2 - kSpoke, 8);
    arc(loop, x, y, inner, from + M_PI / 2 - kSpoke, from + kSpoke, 8);
    return loop;
}

Loop capsule(double x0, double y0, double x1, double y1, double radius, int corners) {
    const double angle = std::atan2(y1 - y0, x1 - x0);
    Loop loop;
    arc(loop, x1, y1, radius, angle - M_PI / 2, angle + M_PI / 2, corners);
    arc(loop, x0, y0, radius, angle + M_PI / 2, angle + 3 * M_PI / 2, corners);
    return loop;
}

Loop reversed(Loop loop) {
    std::ranges::reverse(loop);
    return loop;
}

Loop square(double size) {
    return {at(0, 0), at(size, 0), at(size, size), at(0, size)};
}

/// Uniform in [-1, 1], the same on every machine.
class Noise {
public:
    explicit Noise(unsigned seed) : m_random(seed) {}
    double operator()() { return static_cast<double>(m_random()) / 2147483647.5 - 1.0; }

private:
    std::mt19937 m_random;
};

Shape raggedPiece(double x, double y, int corners, Noise& noise) {
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners;
        const double radius = kPitch * (0.3 + 0.1 * noise());
        loop.push_back(at(x + radius * std::cos(angle), y + radius * std::sin(angle)));
    }
    Shape shape;
    shape.add(loop);
    return shape;
}

Shape smallArea(int kind, double x, double y, Noise& noise) {
    Shape shape;
    if (kind == 0) {
        shape.add(capsule(x, y, x + 2 * kPitch * noise(), y + 2 * kPitch * (1.1 + noise()), 75e3, 20));
    } else if (kind == 1) {
        shape.add(circle(x, y, 300e3, 50));
        shape.add(reversed(circle(x, y, 150e3, 50)));
    } else if (kind == 2) {
        Loop pad;
        for (int corner = 0; corner < 4; ++corner) {
            const double angle = M_PI / 2 * corner;
            const double dx = corner == 0 || corner == 3 ? 200e3 : -200e3;
            const double dy = corner < 2 ? 100e3 : -100e3;
            arc(pad, x + dx, y + dy, 50e3, angle, angle + M_PI / 2, 4);
        }
        shape.add(pad);
    } else {
        shape = raggedPiece(x, y, 12 + static_cast<int>(40 * (1 + noise())), noise);
    }
    return shape;
}

}  // namespace

std::size_t Set::vertexCount() const {
    std::size_t count = 0;
    for (const Shape& shape : shapes) {
        count += shape.points.size();
    }
    return count;
}

Set plane(const std::string& name, int holes) {
    // A thermal relief is four loops: 1.6 loops per place.
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(holes / 1.6))));
    Noise noise(1);
    Shape shape;
    shape.add(square((side + 1) * kPitch));
    for (int i = 0; i < side * side; ++i) {
        const bool isOnLattice = i % side < side / 2;
        const double x = kPitch * (i % side + 1) + (isOnLattice ? 0.0 : 150e3 * noise());
        const double y = kPitch * (i / side + 1) + (isOnLattice ? 0.0 : 150e3 * noise());
        if (i % 5 != 0) {
            shape.add(reversed(circle(x, y, 300e3, 32)));
            continue;
        }
        for (int quarter = 0; quarter < 4; ++quarter) {
            shape.add(reversed(slot(x, y, 200e3, 320e3, M_PI / 2 * quarter)));
        }
    }
    return {name, {shape}};
}

Set pour(const std::string& name, int holes) {
    constexpr int kPerBundle = 20;
    constexpr double kBundleWidth = 16e6;
    constexpr double kBundleHeight = kPerBundle * 250e3 + 1.5e6;
    const int bundles = std::max(1, holes / (kPerBundle + kPerBundle / 2));
    const int columns = std::max(1, static_cast<int>(std::lround(std::sqrt(bundles * kBundleHeight / kBundleWidth))));
    const int rows = (bundles + columns - 1) / columns;
    Noise noise(2);
    Shape shape;
    const double width = columns * (kBundleWidth + 4e6) + 4e6;
    const double height = rows * kBundleHeight + 4e6;
    shape.add({at(0, 0), at(width, 0), at(width, height), at(0, height)});
    for (int bundle = 0; bundle < columns * rows; ++bundle) {
        const double x = 3e6 + (kBundleWidth + 4e6) * (bundle % columns);
        const double y = 2e6 + kBundleHeight * (bundle / columns);
        for (int trace = 0; trace < kPerBundle; ++trace) {
            const double ty = y + 250e3 * trace;
            shape.add(reversed(capsule(x + 1e6 * noise(), ty, x + kBundleWidth - 2e6 + 1e6 * noise(), ty, 100e3, 5)));
        }
        for (int via = 0; via < kPerBundle / 2; ++via) {
            shape.add(reversed(circle(x + 1.4e6 * via + 100e3 * noise(), y + kBundleHeight - 900e3, 250e3, 24)));
        }
    }
    return {name, {shape}};
}

Set areas(const std::string& name, int count) {
    Noise noise(3);
    Set set{name, {}};
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i) {
        set.shapes.push_back(smallArea(i % 4, 3 * kPitch * (i % side), 3 * kPitch * (i / side), noise));
    }
    return set;
}

std::vector<Set> standardSets(bool withHuge) {
    std::vector<Set> sets = {areas("areas 1k", 1000),   areas("areas 20k", 20000), plane("plane 1k", 1500),
                             plane("plane 10k", 16000), pour("pour 1k", 2900),     pour("pour 20k", 58000)};
    if (withHuge) {
        sets.push_back(plane("plane 25k", 40000));
        sets.push_back(plane("plane 100k", 160000));
    }
    return sets;
}

}  // namespace tri::bench
