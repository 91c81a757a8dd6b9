#include "render/modelling/let_tables.h"

#include <QtTest>
#include <map>
#include <set>
#include <utility>

using namespace render;

/// The index tables all lets share.
class LetTablesTest : public QObject {
    Q_OBJECT

    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    static std::map<Edge, int> edgesOf(const LetTables& tables, const IndexRun& run) {
        std::map<Edge, int> edges;
        for (std::uint32_t i = run.first; i < run.first + run.count; i += 3) {
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                ++edges[{tables.indices[i + corner], tables.indices[i + (corner + 1) % 3]}];
            }
        }
        return edges;
    }

    static void addSolids() {
        QTest::addColumn<std::uint32_t>("bucket");
        for (std::uint32_t bucket = 0; bucket < shader::kBucketCount; ++bucket) {
            if (bucket % shader::kLevelCount < shader::kLevelFlat) {
                QTest::addRow("topology %u, level %u", bucket / shader::kLevelCount, bucket % shader::kLevelCount)
                    << bucket;
            }
        }
    }

private slots:
    /// Every edge is there once in either direction: no gaps, no overlaps, and all faces turned outwards or all
    /// inwards.
    void solidsAreClosed_data() { addSolids(); }
    void solidsAreClosed() {
        QFETCH(std::uint32_t, bucket);
        const LetTables tables = makeLetTables();
        const auto edges = edgesOf(tables, tables.run(bucket, {}));
        QVERIFY(!edges.empty());
        for (const auto& [edge, count] : edges) {
            QCOMPARE(count, 1);
            QVERIFY(edges.contains({edge.second, edge.first}));
        }
    }

    void boxesAreClosed() {
        const LetTables tables = makeLetTables();
        const IndexRun run = tables.boxRun(shader::kDrawOfRest, {});
        QCOMPARE(run.count, 36U);
        for (const auto& [edge, count] : edgesOf(tables, run)) {
            QCOMPARE(count, 1);
            QVERIFY(edgesOf(tables, run).contains({edge.second, edge.first}));
        }
        QCOMPARE(tables.boxRun(shader::kDrawOfRest, {true, true, false}).count, 30U);
    }

    void groupsAreAsManyBoxes() {
        const LetTables tables = makeLetTables();
        for (const SeenFaces faces : {SeenFaces{}, SeenFaces{true, false, false}, SeenFaces{false, true, true}}) {
            const IndexRun one = tables.boxRun(shader::kDrawOfRest, faces);
            const IndexRun group = tables.boxRun(shader::kLevelQuad, faces);
            QCOMPARE(group.count, one.count * shader::kQuadGroup);
            std::multiset<std::uint32_t> expected;
            for (std::uint32_t nth = 0; nth < shader::kQuadGroup; ++nth) {
                for (std::uint32_t i = one.first; i < one.first + one.count; ++i) {
                    expected.insert(tables.indices[i] | shader::kIndexGrouped | nth << shader::kIndexQuadShift);
                }
            }
            const auto first = tables.indices.begin() + group.first;
            QVERIFY(expected == std::multiset<std::uint32_t>(first, first + group.count));
            QVERIFY(*std::max_element(first, first + group.count) < 1U << 24U);
        }
    }

    void openLaddersHaveThePapersVertexCounts() {
        const LetTables tables = makeLetTables();
        const std::pair<std::uint32_t, std::size_t> expected[] = {
            {shader::kLevel64, 64}, {shader::kLevel32, 32}, {shader::kLevel16, 16}};
        for (const auto& [level, vertices] : expected) {
            const IndexRun run = tables.run(level, {});
            const std::set<std::uint32_t> used(tables.indices.begin() + run.first,
                                               tables.indices.begin() + run.first + run.count);
            QCOMPARE(used.size(), vertices);
        }
    }

    void runsHoldExactlyTheFacesThatAreSeen_data() { addSolids(); }
    void runsHoldExactlyTheFacesThatAreSeen() {
        QFETCH(std::uint32_t, bucket);
        const LetTables tables = makeLetTables();
        for (const SeenFaces faces : {SeenFaces{true, false, false}, SeenFaces{true, true, false},
                                      SeenFaces{false, true, true}, SeenFaces{false, false, true}}) {
            const IndexRun run = tables.run(bucket, faces);
            QVERIFY(run.count > 0);
            for (std::uint32_t i = run.first; i < run.first + run.count; i += 3) {
                int lower =
                    0;  // corners on the lower face: none, some or all tell upper, wall and lower triangles apart
                for (std::uint32_t corner = 0; corner < 3; ++corner) {
                    lower += static_cast<int>(tables.indices[i + corner] & 1U);
                }
                QVERIFY(lower == 0 ? faces.upper : lower == 3 ? faces.lower : faces.walls);
            }
        }
    }

    void flatLevelsShowOneFaceOnly_data() {
        QTest::addColumn<std::uint32_t>("bucket");
        QTest::addColumn<std::uint32_t>("indices");
        QTest::newRow("quad") << shader::kDrawOfRest << 6U;
        QTest::newRow("group of quads") << shader::kLevelQuad << 6U * shader::kQuadGroup;
        QTest::newRow("stroke") << shader::kLevelFlat << 18U;
        QTest::newRow("tube") << shader::kLevelCount + shader::kLevelFlat << 48U;
    }
    void flatLevelsShowOneFaceOnly() {
        QFETCH(std::uint32_t, bucket);
        QFETCH(std::uint32_t, indices);
        const LetTables tables = makeLetTables();
        for (const SeenFaces faces : {SeenFaces{true, true, false}, SeenFaces{false, true, true}}) {
            const IndexRun run = tables.run(bucket, faces);
            QCOMPARE(run.count, indices);
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                QCOMPARE((tables.indices[i] & 1U) == 0, faces.upper);
            }
        }
    }
};

QTEST_APPLESS_MAIN(LetTablesTest)
#include "let_tables_test.moc"
