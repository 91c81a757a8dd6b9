// Every cell of a map against measuring from its centre to all copper, one by one.
#include "model/clearance/clearance_map.h"

#include <QtTest>
#include <array>
#include <random>

#include "model/base/parallel.h"
#include "model/board/document_builder.h"
#include "model/figures/distance.h"
#include "tests/unit/model/figures/element_spacing.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::ClearanceMap;
using model::DistanceField;
using model::DocumentBuilder;
using model::ElementId;
using model::LayerId;
using model::MapFrame;
using model::NetId;
using model::Nm;
using model::Point;
using model::PointD;

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

LayerId beginLayer(DocumentBuilder& builder, const char* name, model::LayerType type = model::LayerType::Signal) {
    const LayerId id = addLayer(builder, name, type);
    builder.beginLayer(id);
    return id;
}

void addRectangle(DocumentBuilder& builder, Point min, Point max, NetId net) {
    model::ShapeSketch sketch;
    sketch.addPolygon(std::array<Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}}, false);
    builder.addArea({builder.addShape(sketch), {}}, of(net));
}

/// An island with a round hole, turned.
void addPlane(DocumentBuilder& builder, Point at, NetId net) {
    model::ShapeSketch sketch;
    sketch.addPolygon(
        std::array<Point, 4>{{{-900'000, -700'000}, {800'000, -600'000}, {900'000, 700'000}, {-700'000, 800'000}}},
        false);
    sketch.addCircle({100'000, 50'000}, 350'000, true);
    model::Placement placement;
    placement.origin = at;
    placement.clockwiseDeg = 30;
    builder.addArea({builder.addShape(sketch), placement}, of(net));
}

/// Copper of all kinds over 8 mm, on two layers; the last net has nothing, and one element in four none.
std::shared_ptr<const model::Document> randomBoard(std::uint32_t seed) {
    DocumentBuilder builder;
    std::vector<NetId> nets(2);  // none
    for (int i = 0; i < 6; ++i) {
        nets.push_back(builder.addNet("n" + std::to_string(i)));
    }
    std::mt19937 random(seed);
    const auto at = [&] { return static_cast<Nm>(random() % 8'000'000); };
    for (const char* name : {"top", "bottom"}) {
        beginLayer(builder, name);
        for (int i = 0; i < 40; ++i) {
            const NetId net = nets[random() % nets.size()];
            const Point a{at(), at()};
            switch (i % 4) {
                case 0: builder.addCircle({a, 300 * kUm, i % 8 == 0 ? 100 * kUm : 0}, of(net)); break;
                case 1: builder.addLine({a, {at(), at()}, 60 * kUm, 0}, of(net)); break;
                case 2:
                    builder.addArc({{a, {a.x + 500'000, a.y}, model::EdgeKind::ArcClockwise},
                                    {a.x + 500'000, a.y + 500'000},
                                    80 * kUm,
                                    0},
                                   of(net));
                    break;
                default: i % 20 == 3 ? addPlane(builder, a, net) : void(builder.addCircle({a, 700 * kUm, 0}, of(net)));
            }
        }
    }
    return builder.finish();
}

DistanceField fieldTo(const model::Document& board, LayerId layer, const std::vector<ElementId>& targets) {
    return *DistanceField::toTargets(board, layer, targets);
}

DistanceField fieldBetween(const model::Document& board, LayerId layer) {
    base::Progress progress;
    return *DistanceField::betweenNets(board, layer, progress);
}

ClearanceMap mapOf(const DistanceField& field, const MapFrame& frame, double reach) {
    base::Progress progress;
    return *field.map(frame, reach, progress);
}

double distanceTo(const model::Document& board, ElementId element, PointD location) {
    model::FigureTable dot;
    dot.addTrack(location, location, 0.0);
    model::FigureTable figures;
    figures.add(board, element);
    double least = kEndless;
    for (std::size_t row = 0; row < figures.size(); ++row) {
        least = std::min(least, model::spacingBetween(dot, 0, figures, row)->distance);
    }
    return least;
}

/// Nets as betweenNets takes them, by element: loose copper grows into what it touches until nothing changes.
std::vector<std::size_t> netsOf(const model::Document& board, LayerId layer) {
    std::vector<std::size_t> nets(board.elements.size(), board.nets.size());
    const auto [first, count] = board.layer(layer).elements;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> touches;
    for (std::uint32_t i = first; i < first + count; ++i) {
        nets[i] = board.elements.net[i].isValid() ? board.elements.net[i].row() : board.nets.size();
    }
    const std::vector<std::size_t> own = nets;
    for (bool isChanged = true; std::exchange(isChanged, false);) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            for (std::uint32_t j = first; j < first + count && own[i] == board.nets.size(); ++j) {
                if (nets[j] < nets[i] &&
                    figure_testing::spacingBetween(board, ElementId{i}, ElementId{j})->distance <= model::kTouchNm) {
                    nets[i] = nets[j];
                    isChanged = true;
                }
            }
        }
    }
    return nets;
}

double spacingAt(const model::Document& board, LayerId layer, const std::vector<std::size_t>& nets, PointD location) {
    std::vector<double> nearest(board.nets.size() + 1, kEndless);
    const auto [first, count] = board.layer(layer).elements;
    for (std::uint32_t i = first; i < first + count; ++i) {
        nearest[nets[i]] = std::min(nearest[nets[i]], distanceTo(board, ElementId{i}, location));
    }
    std::ranges::sort(nearest);
    return nearest[0] <= 0 ? 0.0 : nearest[0] + nearest[1];
}

void compare(double found, double expected, double reach, PointD at) {
    const bool isRight = expected <= reach - 1.0   ? std::abs(found - expected) <= 1.0
                         : expected >= reach + 1.0 ? found == kEndless
                                                   : true;
    if (!isRight) {
        qFatal("at %f %f: %f instead of %f", at.x, at.y, found, expected);
    }
}

constexpr MapFrame kWhole{{-300'000.0, -300'000.0}, 90'000.0, 97, 95};

}  // namespace

class ClearanceMapTest : public QObject {
    Q_OBJECT

private slots:
    void targetsAreAsFarAsEveryCellMeasures() {
        for (std::uint32_t seed = 0; seed < 4; ++seed) {
            const auto board = randomBoard(seed);
            std::vector<ElementId> targets;
            for (std::uint32_t i = seed; i < 80; i += 5) {
                targets.emplace_back(i);
            }
            for (const double reach : {200.0 * kUm, 5'000.0 * kUm}) {
                const ClearanceMap map = mapOf(fieldTo(*board, LayerId{0U}, targets), kWhole, reach);
                forEachCell(map, [&](PointD location, double found) {
                    double expected = kEndless;
                    for (const ElementId target : targets) {
                        if (board->elements.layer[target.row()] == LayerId{0U}) {
                            expected = std::min(expected, distanceTo(*board, target, location));
                        }
                    }
                    compare(found, expected, reach, location);
                });
            }
        }
    }

    void gapsAreAsWideAsEveryCellMeasures() {
        for (std::uint32_t seed = 0; seed < 4; ++seed) {
            const auto board = randomBoard(seed);
            const auto nets = netsOf(*board, LayerId{1U});
            for (const double reach : {300.0 * kUm, 5'000.0 * kUm}) {
                const ClearanceMap map = mapOf(fieldBetween(*board, LayerId{1U}), kWhole, reach);
                forEachCell(map, [&](PointD location, double found) {
                    compare(found, spacingAt(*board, LayerId{1U}, nets, location), reach, location);
                });
            }
        }
    }

    void noValueChangesFasterThanThePlace() {
        const auto board = randomBoard(7);
        for (const bool isBetween : {false, true}) {
            const DistanceField field = isBetween ? fieldBetween(*board, LayerId{0U})
                                                  : fieldTo(*board, LayerId{0U}, {ElementId{0}, ElementId{5}});
            const ClearanceMap map = mapOf(field, kWhole, model::kMostMapReach);
            const double most = (isBetween ? 2.0 : 1.0) * kWhole.cell + 1.0;
            for (std::size_t i = 0; i + kWhole.width + 1 < map.nm.size(); ++i) {
                for (const std::size_t next : {i + 1, i + kWhole.width}) {
                    const bool isSameRow = next != i + 1 || next % kWhole.width != 0;
                    const bool isOnCopper = isBetween && (map.nm[i] == 0.0F || map.nm[next] == 0.0F);
                    QVERIFY(!isSameRow || isOnCopper || std::abs(double{map.nm[i]} - double{map.nm[next]}) <= most);
                }
            }
        }
    }

    void moreReachAddsPlacesAndMoreTargetsAreNearer() {
        const auto board = randomBoard(3);
        const ClearanceMap far = mapOf(fieldTo(*board, LayerId{0U}, {ElementId{1}}), kWhole, 4e6);
        const ClearanceMap near = mapOf(fieldTo(*board, LayerId{0U}, {ElementId{1}}), kWhole, 1e6);
        const ClearanceMap more = mapOf(fieldTo(*board, LayerId{0U}, {ElementId{1}, ElementId{4}}), kWhole, 4e6);
        int cut = 0;
        for (std::size_t i = 0; i < far.nm.size(); ++i) {
            QVERIFY(more.nm[i] <= far.nm[i]);
            QCOMPARE(double{near.nm[i]}, far.nm[i] <= 1e6F ? double{far.nm[i]} : kEndless);
            cut += near.nm[i] != far.nm[i] ? 1 : 0;
        }
        QVERIFY(cut > 100);
    }

    void whatIsFarFromAIsAsFarFromB() {
        DocumentBuilder builder;
        const LayerId top = beginLayer(builder, "top");
        std::mt19937 random(5);
        std::vector<Point> locations;
        for (int i = 0; i < 30; ++i) {
            locations.push_back({static_cast<Nm>(random() % 8'000'000), static_cast<Nm>(random() % 8'000'000)});
            builder.addCircle({locations.back(), 20 * kUm, 0}, {});
        }
        const auto board = builder.finish();
        for (std::uint32_t i = 0; i + 1 < 30; ++i) {
            const DistanceField a = fieldTo(*board, top, {ElementId{i}});
            const DistanceField b = fieldTo(*board, top, {ElementId{i + 1}});
            QCOMPARE(a.at(base::toDouble(locations[i + 1]), 10e6), b.at(base::toDouble(locations[i]), 10e6));
        }
    }

    void aGapIsAsWideAllAcross() {
        DocumentBuilder builder;
        const NetId a = builder.addNet("a");
        const NetId b = builder.addNet("b");
        const LayerId top = beginLayer(builder, "top");
        builder.addLine({{0, 0}, {5'000'000, 0}, 200 * kUm, 0}, of(a));
        addRectangle(builder, {0, 350'000}, {5'000'000, 1'000'000}, b);
        const auto board = builder.finish();
        const DistanceField field = fieldBetween(*board, top);
        for (const double y : {100'001.0, 170'000.5, 349'999.0}) {
            QCOMPARE(field.at({2'500'000.0, y}, 1e6), 250'000.0);
        }
        QCOMPARE(field.at({2'500'000.0, 50'000.0}, 1e6), 0.0);
        QCOMPARE(field.at({2'500'000.0, 350'001.0}, 1e6), 0.0);
        QCOMPARE(field.at({2'500'000.0, 200'000.0}, 249'999.0), kEndless);
        QCOMPARE(field.at({2'500'000.0, -200'000.0}, 1e6), 100'000.0 + 550'000.0);
    }

    void looseCopperBelongsToWhatItTouches() {
        DocumentBuilder builder;
        const NetId a = builder.addNet("a");
        const NetId b = builder.addNet("b");
        const LayerId top = beginLayer(builder, "top");
        addRectangle(builder, {0, 0}, {1'000'000, 100'000}, a);
        addRectangle(builder, {0, 100'000}, {1'000'000, 200'000}, {});  // touches a
        addRectangle(builder, {0, 200'000}, {1'000'000, 300'000}, {});  // touches that
        addRectangle(builder, {0, 350'000}, {1'000'000, 450'000}, {});  // alone
        addRectangle(builder, {0, 700'000}, {1'000'000, 800'000}, b);
        const auto board = builder.finish();
        const DistanceField field = fieldBetween(*board, top);
        QCOMPARE(field.at({500'000.0, 320'000.0}, 1e6), 50'000.0);
        QCOMPARE(field.at({500'000.0, 500'000.0}, 1e6), 250'000.0);
    }

    void platedHolesCount() {
        DocumentBuilder builder;
        const NetId a = builder.addNet("a");
        const LayerId top = beginLayer(builder, "top");
        const LayerId inner = beginLayer(builder, "inner");
        model::Layer drill;
        drill.name = "drill";
        drill.type = model::LayerType::Drill;
        drill.spanTop = top;
        drill.spanBottom = inner;
        builder.beginLayer(builder.addLayer(drill));
        DocumentBuilder::Origin origin = of(a);
        origin.flags = model::kHole | model::kPlated;
        const ElementId hole = builder.addCircle({{0, 0}, 400 * kUm, 350 * kUm}, origin);
        const auto board = builder.finish();
        QCOMPARE(fieldTo(*board, inner, {hole}).at({1'000'000.0, 0.0}, 1e6), 800'000.0);
    }

    void oneThreadGivesTheSameBits() {
        const auto board = randomBoard(11);
        const DistanceField field = fieldBetween(*board, LayerId{0U});
        const ClearanceMap all = mapOf(field, kWhole, 2e6);
        const base::ThreadLimit oneThread(1);
        const ClearanceMap alone = mapOf(fieldBetween(*board, LayerId{0U}), kWhole, 2e6);
        QVERIFY(std::memcmp(all.nm.data(), alone.nm.data(), all.nm.size() * sizeof(float)) == 0);
    }

    void onePlaceIsACellOfTheMap() {
        const auto board = randomBoard(2);
        const DistanceField field = fieldBetween(*board, LayerId{0U});
        forEachCell(mapOf(field, kWhole, 1e6), [&](PointD location, double found) {
            QVERIFY(found == field.at(location, 1e6) || std::abs(found - field.at(location, 1e6)) < 0.1);
        });
    }

    void whatCannotBeMappedIsRefused() {
        DocumentBuilder builder;
        const NetId a = builder.addNet("a");
        const LayerId top = beginLayer(builder, "top");
        const LayerId empty = beginLayer(builder, "empty");
        builder.beginLayer(top);
        const ElementId only = builder.addCircle({{0, 0}, 100 * kUm, 0}, of(a));
        const auto board = builder.finish();
        base::Progress progress;
        const auto noTargets = DistanceField::toTargets(*board, empty, std::array{only});
        QVERIFY(!noTargets);
        QCOMPARE(noTargets.error().code, base::ErrorCode::BadUsage);
        QVERIFY(noTargets.error().text.find("empty") != std::string::npos);
        QVERIFY(!DistanceField::toTargets(*board, top, {}));
        QVERIFY(!DistanceField::betweenNets(*board, empty, progress));
        QVERIFY(!DistanceField::betweenNets(*board, top, progress));
        const DistanceField field = fieldTo(*board, top, {only});
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const MapFrame& frame :
             {MapFrame{{0, 0}, 1.0, 0, 5}, MapFrame{{0, 0}, 0.0, 5, 5}, MapFrame{{0, 0}, -1.0, 5, 5},
              MapFrame{{0, 0}, nan, 5, 5}, MapFrame{{nan, 0}, 1.0, 5, 5}, MapFrame{{0, 0}, 1.0, 100'000, 100'000},
              MapFrame{{0, 0}, 1e8, 1, 1}, MapFrame{{2e9, 0}, 1.0, 5, 5}, MapFrame{{0, -1e18}, 1.0, 5, 5}}) {
            const auto refused = field.map(frame, 1e6, progress);
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, base::ErrorCode::BadUsage);
        }
        QCOMPARE(field.at({200'000.0, 0.0}, -5.0), kEndless);
        QCOMPARE(field.at({200'000.0, 0.0}, kEndless), 150'000.0);
        QCOMPARE(field.at({2e9, 0.0}, 1e6), kEndless);  // a cursor may be where no board can
    }

    void aCancelIsSaid() {
        const auto board = randomBoard(1);
        base::Progress progress;
        progress.cancel();
        QCOMPARE(DistanceField::betweenNets(*board, LayerId{0U}, progress).error().code, base::ErrorCode::Cancelled);
        QCOMPARE(fieldBetween(*board, LayerId{0U}).map(kWhole, 1e6, progress).error().code, base::ErrorCode::Cancelled);
    }

private:
    template <class Visit>
    void forEachCell(const ClearanceMap& map, const Visit& visit) {
        for (std::uint32_t row = 0; row < map.frame.height; ++row) {
            for (std::uint32_t column = 0; column < map.frame.width; ++column) {
                visit(map.frame.centreOf(column, row), double{map.nm[std::size_t{row} * map.frame.width + column]});
            }
        }
    }
};

QTEST_GUILESS_MAIN(ClearanceMapTest)
#include "clearance_map_test.moc"
