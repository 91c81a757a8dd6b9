#include "model/geometry/bernstein.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/vectors.h"

namespace model {

namespace {

/// The binomial coefficients of a degree.
std::vector<double> binomials(std::size_t degree) {
    std::vector<double> row(degree + 1, 1.0);
    for (std::size_t i = 1; i < degree; ++i) {
        row[i] = row[i - 1] * static_cast<double>(degree + 1 - i) / static_cast<double>(i);
    }
    return row;
}

bool hasBothSigns(std::span<const double> values) {
    const auto [least, most] = std::ranges::minmax(values);
    return least <= 0 && most >= 0;
}

bool isWithin(std::span<const double> values, double tolerance) {
    return std::ranges::all_of(values, [=](double value) { return std::abs(value) <= tolerance; });
}

struct Part {
    std::vector<double> coefficients;
    Stretch over;
};

/// Halves a part: it becomes its first half, the second is returned.
Part halved(Part& part) {
    std::vector<double>& c = part.coefficients;
    const std::size_t degree = c.size() - 1;
    const double middle = part.over.from + (part.over.to - part.over.from) / 2;
    Part later{std::vector<double>(c.size()), {middle, part.over.to}};
    for (std::size_t step = 0; step <= degree; ++step) {
        later.coefficients[degree - step] = c.back();
        for (std::size_t i = degree; i > step; --i) {
            c[i] = (c[i - 1] + c[i]) / 2;
        }
    }
    part.over.to = middle;
    return later;
}

}  // namespace

std::vector<double> besideLine(const Bezier& curve, PointD origin, PointD unit) {
    std::vector<double> beside;
    for (const Homogeneous& control : curve.controls()) {
        beside.push_back(cross(unit, {control.x - origin.x * control.w, control.y - origin.y * control.w}));
    }
    return beside;
}

std::vector<double> besideCircle(const Bezier& curve, PointD centre, double radius) {
    const std::size_t degree = curve.degree();
    const std::vector<double> own = binomials(degree);
    const std::vector<double> twice = binomials(2 * degree);
    std::vector<double> beside(2 * degree + 1, 0.0);
    for (std::size_t i = 0; i <= degree; ++i) {
        const Homogeneous& a = curve.controls()[i];
        const PointD p = {a.x - centre.x * a.w, a.y - centre.y * a.w};
        for (std::size_t j = 0; j <= degree; ++j) {
            const Homogeneous& b = curve.controls()[j];
            const PointD q = {b.x - centre.x * b.w, b.y - centre.y * b.w};
            beside[i + j] += own[i] * own[j] / twice[i + j] * (dot(p, q) - radius * radius * a.w * b.w);
        }
    }
    return beside;
}

std::vector<Stretch> rootsOf(std::vector<double> coefficients, double tolerance) {
    std::vector<Stretch> roots;
    std::vector<Part> open{{std::move(coefficients), {0.0, 1.0}}};
    while (!open.empty()) {
        const Stretch over = open.back().over;
        const bool isNarrow = over.to - over.from < 1e-15;
        const bool isRoot = isNarrow || isWithin(open.back().coefficients, tolerance);
        if (!isRoot && hasBothSigns(open.back().coefficients)) {
            Part later = halved(open.back());
            std::swap(later, open.back());
            open.push_back(std::move(later));
            continue;
        }
        if (isRoot && !roots.empty() && roots.back().to == over.from) {
            roots.back().to = over.to;
        } else if (isRoot && (!isNarrow || hasBothSigns(open.back().coefficients))) {
            roots.push_back(over);
        }
        open.pop_back();
    }
    return roots;
}

}  // namespace model
