// How fast NURBS curves are evaluated and walked on one core: curve_bench [REPEATS]. Curves of several degrees with
// degree + 8 random control points over a millimetre; millions per second of processor time, best of the repeats.
// "edges" are the lines and arcs that curves are measured by, "chords" those of 5 µm tolerance.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

#include "model/geometry/curve_edges.h"
#include "model/geometry/curve_queries.h"
#include "tests/unit/model/geometry/some_curves.h"

namespace {

/// Calls per second of `call`, which does `count` of them; the best of so many runs.
template <class Call>
double rateOf(int repeats, double count, const Call& call) {
    double best = 0;
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        call();
        best = std::max(best, count / std::max(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 1e-6));
    }
    return best;
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = std::max(argc > 1 ? std::atoi(argv[1]) : 5, 1);
    constexpr int kPoints = 200'000;
    constexpr int kQueries = 1'000;
    double kept = 0;  // what is worked out is used
    std::printf("degree  points M/s  derivatives M/s  edges M/s  chords M/s  nearest k/s\n");
    for (const int degree : {1, 2, 3, 5, 9, 15, 20}) {
        std::mt19937_64 random(static_cast<unsigned>(degree));
        const model::Nurbs curve = model::testing::randomCurve(random, degree, degree + 8, 1e6);
        const model::NurbsView view = curve.view();
        const auto pieces = model::bezierPieces(view);
        const auto at = [&](int i) { return view.to() * i / kPoints; };
        const double points = rateOf(repeats, kPoints, [&] {
            for (int i = 0; i < kPoints; ++i) {
                kept += model::pointOn(view, at(i)).x;
            }
        });
        const double derivatives = rateOf(repeats, kPoints, [&] {
            for (int i = 0; i < kPoints; ++i) {
                kept += model::derivativesOn(view, at(i)).second.x;
            }
        });
        const std::size_t edgeCount = model::edgesAlong(pieces, model::kMeasured).size();
        const double edges = rateOf(repeats, static_cast<double>(edgeCount) * 20, [&] {
            for (int i = 0; i < 20; ++i) {
                kept += model::edgesAlong(pieces, model::kMeasured).back().a.x;
            }
        });
        const std::size_t chordCount = model::chordPoints(pieces, 5e3).size();
        const double chords = rateOf(repeats, static_cast<double>(chordCount) * 200, [&] {
            for (int i = 0; i < 200; ++i) {
                kept += model::chordPoints(pieces, 5e3).back().x;
            }
        });
        const double nearest = rateOf(repeats, kQueries, [&] {
            for (int i = 0; i < kQueries; ++i) {
                kept += model::nearestOn(pieces, {1e3 * i - 5e5, 5e5 - 700.0 * i}).distance;
            }
        });
        std::printf("%6d  %10.2f  %15.2f  %9.2f  %10.2f  %11.1f\n", degree, points / 1e6, derivatives / 1e6,
                    edges / 1e6, chords / 1e6, nearest / 1e3);
    }
    return kept == 0 ? 1 : 0;
}
