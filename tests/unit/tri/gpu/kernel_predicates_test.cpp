#include <QtTest>

#include "shaders/tri/predicates.h"
#include "tests/unit/tri/predicate_vectors.h"

namespace kernel = shader::tri;

namespace {

kernel::ivec2 at(const base::Point& p) {
    return {p.x, p.y};
}

std::int64_t toNumber(kernel::uvec2 words) {
    return static_cast<std::int64_t>(std::uint64_t{words.y} << 32 | words.x);
}

tri::Int128 toNumber(kernel::uvec4 words) {
    const auto high = static_cast<unsigned __int128>(std::uint64_t{words.w} << 32 | words.z) << 64;
    return static_cast<tri::Int128>(high | (std::uint64_t{words.y} << 32 | words.x));
}

}  // namespace

/// The kernels' predicates from 32-bit words give the numbers of tri/predicates.h.
class KernelPredicatesTest : public QObject {
    Q_OBJECT

private slots:
    void allNumbersAreThoseOf128Bits() {
        for (const cases::Question& q : cases::predicateQuestions()) {
            const auto& [a, b, c, d] = q.points;
            QCOMPARE(toNumber(kernel::orient(at(a), at(b), at(c))), tri::orient(a, b, c));
            QVERIFY(toNumber(kernel::inCircle(at(a), at(b), at(c), at(d))) == tri::inCircle(a, b, c, d));
            const kernel::uvec4 ids{q.ids[0], q.ids[1], q.ids[2], q.ids[3]};
            QCOMPARE(kernel::isInPerturbedCircle(at(a), at(b), at(c), at(d), ids),
                     tri::isInPerturbedCircle({a, q.ids[0]}, {b, q.ids[1]}, {c, q.ids[2]}, {d, q.ids[3]}));
        }
    }

    void ranksGrowWithTheNumber() {
        kernel::uvec4 before{1, 0, 0, 0};
        for (int bit = 1; bit < 127; ++bit) {
            kernel::uvec4 power{0, 0, 0, 0};
            power[bit / 32] = 1U << bit % 32;
            const kernel::uvec4 above =
                kernel::add128(power, kernel::uvec4{bit > 40 ? 0 : 1, bit > 40 ? 1 << 15 : 0, 0, 0});
            QVERIFY(kernel::rankOf(before) < kernel::rankOf(power));
            QVERIFY(kernel::rankOf(power) <= kernel::rankOf(above));
            QVERIFY(kernel::rankOf(power) < 1U << 31);
            before = power;
        }
        QVERIFY(kernel::rankOf({0, 0, 0, 3U << 20}) > kernel::rankOf({0, 0, 0, 5U << 19}));
        QVERIFY(kernel::rankOf({0, 3U << 20, 0, 0}) > kernel::rankOf({0, 5U << 19, 0, 0}));
    }
};

QTEST_APPLESS_MAIN(KernelPredicatesTest)
#include "kernel_predicates_test.moc"
