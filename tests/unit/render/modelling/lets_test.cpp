#include "render/modelling/lets.h"

#include <QtTest>
#include <cmath>
#include <random>
#include <set>

#include "model/board/document_builder.h"

using model::DocumentBuilder;
using model::EdgeKind;
using model::PathNode;
using model::Point;
using shader::Let;

namespace {

std::uint32_t kindOf(const Let& let) {
    return let.meta & shader::kLetKindMask;
}

/// One layer's lets as they are drawn.
struct Drawn {
    std::vector<Let> lets;
    std::vector<shader::Cluster> clusters;
};

Drawn drawn(const model::Document& document) {
    const render::LayerLets made = render::makeLets(document, model::LayerId{0UL}, {}, 5000.0);
    Drawn result{std::vector<Let>(made.order.size()), std::vector<shader::Cluster>(render::clusterCount(made))};
    render::placeLets(made, model::LayerId{0UL}, 0, result.lets, result.clusters);
    return result;
}

/// A thousand strokes and pads of all kinds.
std::shared_ptr<const model::Document> manyElements() {
    DocumentBuilder builder;
    builder.beginLayer(builder.addLayer({}));
    std::mt19937 random(5);
    const auto any = [&] { return static_cast<int>(random() % 100'000'000U); };
    for (int i = 0; i < 250; ++i) {
        builder.addLine({{any(), any()}, {any(), any()}, 100'000, 0}, {});
        builder.addCircle({{any(), any()}, 500'000, 300'000}, {});
        const PathNode node{{any(), any()}, {any(), any()}, EdgeKind::ArcClockwise};
        builder.addArc({node, {any(), any()}, 100'000}, {});
        const PathNode nodes[] = {{{any(), any()}, {}, {}}, node, {{any(), any()}, {}, {}}};
        builder.addTrail(nodes, 150'000, {});
    }
    return builder.finish();
}

}  // namespace

class LetsTest : public QObject {
    Q_OBJECT

private slots:
    void everyElementHasItsLets() {
        const auto document = manyElements();
        const render::LayerLets made = render::makeLets(*document, model::LayerId{0UL}, {}, 5000.0);
        std::set<std::uint32_t> seen;
        for (const Let& let : made.lets) {
            seen.insert(let.element);
        }
        QCOMPARE(seen.size(), document->elements.size());
    }

    void clustersHoldAllLetsOnceWithinTheirBoxes() {
        const auto document = manyElements();
        const Drawn made = drawn(*document);
        std::uint32_t next = 0;
        for (const shader::Cluster& cluster : made.clusters) {
            QCOMPARE(cluster.firstLet, next);
            next += cluster.count;
            for (std::uint32_t i = cluster.firstLet; i < next; ++i) {
                const Let& let = made.lets[i];
                const bool isArc = kindOf(let) == shader::kLetArc;
                for (int step = 0; step <= 16; ++step) {
                    const float t = static_cast<float>(step) / 16.0F;
                    const float angle = let.p3 + let.p4 * t;
                    const glm::vec2 p =
                        isArc ? glm::vec2(let.p0, let.p1) + let.p2 * glm::vec2(std::cos(angle), std::sin(angle))
                              : glm::mix(glm::vec2(let.p0, let.p1), glm::vec2(let.p2, let.p3), t);
                    const float r = (isArc ? let.p5 : let.p4) - 1e-4F;
                    QVERIFY(glm::all(glm::lessThanEqual(cluster.boxMin, p - r)));
                    QVERIFY(glm::all(glm::greaterThanEqual(cluster.boxMax, p + r)));
                }
            }
        }
        QCOMPARE(next, made.lets.size());
    }

    void arcsAreSplitSoThatTheFinestRingIsWithinTolerance() {
        for (const double radius : {20e3, 500e3, 5e6, 80e6, 400e6}) {
            DocumentBuilder builder;
            builder.beginLayer(builder.addLayer({}));
            const PathNode node{{static_cast<int>(radius), 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
            builder.addArc({node, node.point, 10'000}, {});
            const auto document = builder.finish();
            const render::LayerLets made = render::makeLets(*document, model::LayerId{0UL}, {}, 5000.0);
            double total = 0.0;
            for (const Let& let : made.lets) {
                const double chord = static_cast<double>(let.p4) / shader::kArcFineChords;
                const double sagittaNm = (radius + 5000.0) * (1 - std::cos(chord / 2));
                QVERIFY2(sagittaNm < 5050.0, qPrintable(QString::number(sagittaNm)));
                total += static_cast<double>(let.p4);
            }
            QVERIFY(std::abs(total - 2 * M_PI) < 1e-3);
        }
    }

    void aPenWiderThanItsArcBecomesStrokesFromEndToEnd() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        const PathNode node{{100'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        builder.addArc({node, {-100'000, 0}, 400'000}, {});
        const auto document = builder.finish();
        const render::LayerLets made = render::makeLets(*document, model::LayerId{0UL}, {}, 5000.0);
        bool reachesStart = false;
        bool reachesEnd = false;
        for (const Let& let : made.lets) {
            QCOMPARE(kindOf(let), shader::kLetStadium);
            QVERIFY(std::abs(std::hypot(let.p0, let.p1) - 0.1F) < 1e-5F);
            reachesStart = reachesStart || let.p0 == 0.1F;
            reachesEnd = reachesEnd || let.p2 == -0.1F;
        }
        QVERIFY(reachesStart && reachesEnd);
    }

    void platedHolesAreATubeAndABore() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        DocumentBuilder::Origin hole;
        hole.flags = model::kHole | model::kPlated;
        builder.addCircle({{0, 0}, 1'000'000, 950'000}, hole);
        const auto document = builder.finish();
        const render::LayerLets made = render::makeLets(*document, model::LayerId{0UL}, {}, 5000.0);
        QCOMPARE(made.lets.size(), 2U);
        QCOMPARE(made.lets[0].p5, 0.475F);
        QVERIFY((made.lets[1].meta & shader::kLetBore) != 0);
        QCOMPARE(made.lets[1].p4, 0.475F);
    }

    void strokesWithoutWidthAreCountedAndNotDrawn() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        DocumentBuilder::Origin origin;
        origin.line = 12;
        builder.addLine({{0, 0}, {1000, 0}, 0, 0}, origin);
        const auto document = builder.finish();
        const render::LayerLets made = render::makeLets(*document, model::LayerId{0UL}, {}, 5000.0);
        QVERIFY(made.lets.empty());
        QCOMPARE(made.zeroWidthTracks, 1U);
        QCOMPARE(made.firstZeroWidthLine, 12U);
    }
};

QTEST_APPLESS_MAIN(LetsTest)
#include "lets_test.moc"
