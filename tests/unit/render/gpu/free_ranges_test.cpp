#include "render/gpu/free_ranges.h"

#include <QtTest>
#include <random>
#include <vector>

using namespace render::gpu;

class FreeRangesTest : public QObject {
    Q_OBJECT

    struct Taken {
        std::uint64_t offset;
        std::uint64_t bytes;
    };
    using Dice = std::mt19937_64;

    /// A block, and who has each of its bytes.
    struct Block {
        FreeRanges ranges;
        std::vector<bool> isTaken;
        std::vector<Taken> parts;

        explicit Block(std::uint64_t bytes) : ranges(bytes), isTaken(bytes) {}

        /// Whether there is room at a multiple of `alignment`, found the slow way.
        bool hasRoom(std::uint64_t bytes, std::uint64_t alignment) const {
            for (std::uint64_t at = 0; at + bytes <= isTaken.size(); at += alignment) {
                const auto begin = isTaken.begin() + static_cast<std::ptrdiff_t>(at);
                if (std::find(begin, begin + static_cast<std::ptrdiff_t>(bytes), true) ==
                    begin + static_cast<std::ptrdiff_t>(bytes)) {
                    return true;
                }
            }
            return false;
        }
        void mark(const Taken& part, bool taken) {
            for (std::uint64_t at = part.offset; at < part.offset + part.bytes; ++at) {
                QCOMPARE(bool(isTaken.at(at)), !taken);
                isTaken.at(at) = taken;
            }
        }
        void take(std::uint64_t bytes, std::uint64_t alignment) {
            const bool isPossible = hasRoom(bytes, alignment);
            const std::optional<std::uint64_t> offset = ranges.take(bytes, alignment);
            QCOMPARE(offset.has_value(), isPossible);
            if (offset) {
                QCOMPARE(*offset % alignment, std::uint64_t{0});
                parts.push_back({*offset, bytes});
                mark(parts.back(), true);
            }
        }
        void give(std::size_t which) {
            std::swap(parts[which], parts.back());
            ranges.give(parts.back().offset, parts.back().bytes);
            mark(parts.back(), false);
            parts.pop_back();
        }
    };

private slots:
    void whatIsTakenNeverOverlapsAndAllComesBack_data() {
        QTest::addColumn<int>("seed");
        QTest::addColumn<int>("largest");
        for (int seed = 1; seed <= 20; ++seed) {
            QTest::addRow("small parts, %d", seed) << seed << 40;
            QTest::addRow("parts of all sizes, %d", seed) << seed << 900;
        }
    }
    void whatIsTakenNeverOverlapsAndAllComesBack() {
        QFETCH(int, seed);
        QFETCH(int, largest);
        Dice dice(static_cast<Dice::result_type>(seed));
        const auto roll = [&dice](std::uint64_t most) { return dice() % most; };
        Block block(1000);
        for (int i = 0; i < 600; ++i) {
            if (block.parts.empty() || roll(100) < 55) {
                block.take(1 + roll(static_cast<std::uint64_t>(largest)), std::uint64_t{1} << roll(8));
            } else {
                block.give(roll(block.parts.size()));
            }
            QCOMPARE(block.ranges.isAllFree(), block.parts.empty());
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        while (!block.parts.empty()) {
            block.give(roll(block.parts.size()));
        }
        QVERIFY(block.ranges.isAllFree());
        QCOMPARE(block.ranges.take(1000, 1 << 7), std::optional<std::uint64_t>(0));
    }

    void aBlockIsTakenToItsLastByte() {
        FreeRanges ranges(256);
        QCOMPARE(ranges.bytes(), std::uint64_t{256});
        QVERIFY(!ranges.take(257, 1));
        for (std::uint64_t i = 0; i < 4; ++i) {
            QCOMPARE(ranges.take(64, 64), std::optional(64 * i));
        }
        QVERIFY(!ranges.take(1, 1));
        ranges.give(128, 64);
        QVERIFY(!ranges.take(65, 1));
        QCOMPARE(ranges.take(64, 1), std::optional<std::uint64_t>(128));
    }

    void whatAlignmentLeavesOutStaysFree() {
        FreeRanges ranges(1024);
        QCOMPARE(ranges.take(1, 1), std::optional<std::uint64_t>(0));
        QCOMPARE(ranges.take(512, 512), std::optional<std::uint64_t>(512));
        QCOMPARE(ranges.take(511, 1), std::optional<std::uint64_t>(1));
    }
};

QTEST_APPLESS_MAIN(FreeRangesTest)
#include "free_ranges_test.moc"
