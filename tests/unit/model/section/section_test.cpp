// Cuts through boards worked out by hand: heights, bores, plating, copies, and what is said where there is nothing.
#include "model/section/section.h"

#include <QRegularExpression>
#include <QtTest>
#include <random>
#include <set>

#include "model/board/document_builder.h"
#include "model/export/section_export.h"
#include "model/formats/registry.h"
#include "model/index/picking.h"
#include "tests/locations.h"
#include "tests/unit/model/hand_made.h"

using namespace model;
using namespace hand_made;

namespace {

/// Three copper layers of 0.1 mm, 1 mm apart, a laminate with the hole taken out, and a drill through all.
enum BoardLayer : std::size_t { Top, Inner, Bottom, Drill, Substrate, Print };

void addLayers(DocumentBuilder& builder) {
    hand_made::addLayers(builder, std::array{StackLayer{"top", LayerType::Signal, 2'200'000, 100'000, Bottom},
                                             StackLayer{"inner", LayerType::Signal, 1'100'000, 100'000, Inner},
                                             StackLayer{"bottom", LayerType::Signal, 0, 100'000, Top},
                                             StackLayer{"drill", LayerType::Drill, 0, 2'300'000, Drill},
                                             StackLayer{"board", LayerType::Body, 100'000, 2'100'000, Substrate},
                                             StackLayer{"print", LayerType::SilkScreen, 2'300'000, 0, Print}});
}

/// A pad of 2 mm on top at (0, 0), a plane of 20 mm on the inner layer, a track along y at x = 5 mm on the bottom, and
/// a plated hole of 1 mm, 0.8 mm open, at (0, 0).
void addCard(DocumentBuilder& builder, bool isBackDrilled = false) {
    addLayers(builder);
    builder.beginLayer(LayerId{Top});
    builder.addCircle({{0, 0}, 2 * kMm, 0}, {});
    builder.beginLayer(LayerId{Inner});
    builder.addArea({builder.addShape(rectangle({-10 * kMm, -10 * kMm}, {10 * kMm, 10 * kMm})), {}}, {});
    builder.beginLayer(LayerId{Bottom});
    builder.addLine({{5 * kMm, -kMm}, {5 * kMm, kMm}, kMm, 0}, {});
    builder.beginLayer(LayerId{Drill});
    const ElementId hole = builder.addCircle({{0, 0}, kMm, 800'000}, flagged(kHole | kPlated));
    if (isBackDrilled) {
        builder.addPlatedSpan({hole, LayerId{Top}, LayerId{Inner}});
    }
    builder.beginLayer(LayerId{Substrate});
    ShapeSketch body = rectangle({-10 * kMm, -10 * kMm}, {10 * kMm, 10 * kMm});
    body.addCircle({0, 0}, kMm / 2, true);
    builder.addArea({builder.addShape(body), {}}, {});
}

std::shared_ptr<const Document> card(bool isBackDrilled = false) {
    DocumentBuilder builder;
    addCard(builder, isBackDrilled);
    return builder.finish();
}

Section cut(const std::shared_ptr<const Document>& board, std::vector<PointD> line) {
    return *makeSection(*indexed(board), {std::move(line), {}});
}

/// Pieces of a layer as "from-to@bottom-top" in micrometres.
QStringList textOf(const std::vector<SectionPiece>& pieces, std::size_t layer) {
    QStringList list;
    for (const SectionPiece& piece : pieces) {
        if (piece.layer == LayerId{layer}) {
            list << QString("%1-%2@%3-%4")
                        .arg(std::lround(piece.from / 1000))
                        .arg(std::lround(piece.to / 1000))
                        .arg(piece.bottom / 1000)
                        .arg(piece.top / 1000);
        }
    }
    return list;
}

std::set<BoardElement> elementsAt(const std::vector<SectionPiece>& pieces, double location) {
    std::set<BoardElement> elements;
    for (const SectionPiece& piece : pieces) {
        if (piece.from <= location && location <= piece.to) {
            elements.insert(piece.at);
        }
    }
    return elements;
}

/// Everything that picking finds under a place, kept to what a section shows.
std::set<BoardElement> elementsUnder(Picker& picker, PointD location) {
    const Document& board = *picker.index().board;
    const std::vector<PickLayer> layers(board.layers.size(), PickLayer{true, 0.0, 1.0});
    std::set<BoardElement> elements;
    for (const Hit& hit : picker.at(location, 0.0, layers, false)) {
        const Layer& layer = board.layer(hit.layer);
        if (hasSubstance(layer) && layer.type != LayerType::Drill && layer.type != LayerType::Rout) {
            elements.insert(hit.at);
        }
    }
    return elements;
}

/// A place close to where something begins or ends is covered or not by rounding.
bool isAtAnEnd(const Section& section, double location) {
    const auto isNear = [&](const SectionPiece& piece) {
        return std::min(std::abs(piece.from - location), std::abs(piece.to - location)) < 3.0;
    };
    return std::ranges::any_of(section.pieces, isNear) || std::ranges::any_of(section.bores, isNear);
}

}  // namespace

class SectionTest : public QObject {
    Q_OBJECT

private slots:
    /// At x = 5.2 mm the board ends, in the middle of the track.
    void whatIsMilledAwayIsLeftOut() {
        DocumentBuilder builder;
        addCard(builder);
        builder.setProfile(builder.addShape(rectangle({-10 * kMm, -10 * kMm}, {5'200'000, 10 * kMm})));
        const auto index = indexed(builder.finish());
        SectionRequest request{{{-20e6, 0}, {20e6, 0}}, {}};
        const auto isSaid = [](const Section& section) {
            return std::ranges::any_of(section.notes, [](const std::string& note) {
                return note == "left out as milled away beyond the board outline or in cut-outs, parts of elements: 1";
            });
        };
        const Section designed = *makeSection(*index, request);
        QCOMPARE(textOf(designed.pieces, Bottom).last(), QString("24500-25500@0-100"));
        QVERIFY(!isSaid(designed));
        request.milled = {{ElementId{index->board->layer(LayerId{Bottom}).elements.first}}};
        const Section made = *makeSection(*index, request);
        QCOMPARE(textOf(made.pieces, Bottom).last(), QString("24500-25200@0-100"));
        QVERIFY(isSaid(made));
    }

    /// A castellation: half of its wall is left.
    void ofAHoleAcrossTheEdgeHalfIsPlated() {
        DocumentBuilder builder;
        addCard(builder);
        builder.setProfile(builder.addShape(rectangle({-10 * kMm, -10 * kMm}, {0, 10 * kMm})));
        const auto index = indexed(builder.finish());
        SectionRequest request{{{-20e6, 0}, {20e6, 0}}, {}};
        request.milled = {{ElementId{index->board->layer(LayerId{Drill}).elements.first}}};
        QCOMPARE(textOf(makeSection(*index, request)->pieces, Drill), QStringList{"19500-19600@0-2300"});
    }

    /// The track ends in a cut-out of its step, and goes on beyond the outline of that.
    void inAPanelCutoutsOfItsStepsAreOpen() {
        DocumentBuilder card;
        addCard(card);
        ShapeSketch outline = rectangle({-10 * kMm, -10 * kMm}, {4'700'000, 10 * kMm});
        outline.append(rectangle({4'800'000, -10 * kMm}, {10 * kMm, 10 * kMm}), {});
        outline.addCircle({5'500'000, 0}, 200'000, true);
        card.setProfile(card.addShape(outline));
        const std::shared_ptr<const Document> step = card.finish();
        DocumentBuilder builder;
        addLayers(builder);
        builder.addInstance({builder.addStep(step), {{30 * kMm, 0}, 0.0, false}, false});
        builder.setProfile(builder.addShape(rectangle({0, -20 * kMm}, {60 * kMm, 20 * kMm})));
        SectionRequest request{{{0, 0}, {100e6, 0}}, {}};
        const auto index = indexed(builder.finish());
        QCOMPARE(textOf(makeSection(*index, request)->pieces, Bottom).last(), QString("34500-35500@0-100"));
        request.milled = {{}, {ElementId{step->layer(LayerId{Bottom}).elements.first}}};
        QCOMPARE(textOf(makeSection(*index, request)->pieces, Bottom).last(), QString("34500-35300@0-100"));
    }

    void holesAreTakenOutOfCopperAndTheirWallsStand() {
        const Section section = cut(card(), {{-20e6, 0}, {20e6, 0}});
        QCOMPARE(section.stations, (std::vector<double>{0.0, 40e6}));
        QCOMPARE(textOf(section.pieces, Top), (QStringList{"19000-19500@2200-2300", "20500-21000@2200-2300"}));
        QCOMPARE(textOf(section.pieces, Inner), (QStringList{"10000-19500@1100-1200", "20500-30000@1100-1200"}));
        QCOMPARE(textOf(section.pieces, Bottom), (QStringList{"24500-25500@0-100"}));
        QCOMPARE(textOf(section.pieces, Drill), (QStringList{"19500-19600@0-2300", "20400-20500@0-2300"}));
        QCOMPARE(textOf(section.pieces, Substrate), (QStringList{"10000-19500@100-1100", "10000-19500@1200-2200",
                                                                 "20500-30000@100-1100", "20500-30000@1200-2200"}));
        const Section solid = *makeSection(*indexed(card()), {{{-20e6, 0}, {20e6, 0}}, {}, true});
        QCOMPARE(textOf(solid.pieces, Substrate), (QStringList{"10000-19500@100-2200", "20500-30000@100-2200"}));
        QCOMPARE(textOf(section.bores, Drill), (QStringList{"19500-20500@0-2300"}));
        QVERIFY(section.notes.empty());
    }

    void inkEndsAtHolesThatNoMaskCloses() {
        DocumentBuilder builder;
        addCard(builder);
        builder.layer(LayerId{Print}).thickness = 10'000;
        builder.beginLayer(LayerId{Print});
        builder.addLine({{-4 * kMm, 0}, {4 * kMm, 0}, 200'000, 0}, {});
        const Section section = cut(builder.finish(), {{-20e6, 0}, {20e6, 0}});
        QCOMPARE(textOf(section.bores, Drill), (QStringList{"19500-20500@0-2300"}));
        const QStringList ink = textOf(section.pieces, Print);
        QVERIFY2(!ink.isEmpty() && ink.first().startsWith("15900-") && ink.last().contains("-24100@"),
                 qPrintable(ink.join(' ')));
        QVERIFY2(std::ranges::none_of(section.pieces,
                                      [](const SectionPiece& piece) {
                                          return piece.layer == LayerId{Print} && piece.to > 19.51e6 &&
                                                 piece.from < 20.49e6;
                                      }),
                 qPrintable(ink.join(' ')));
    }

    void aCutThroughTheWallAloneIsAllCopper() {
        const Section section = cut(card(), {{-20e6, 450'000}, {20e6, 450'000}});
        QCOMPARE(textOf(section.pieces, Drill).size(), 1);
        QCOMPARE(textOf(section.pieces, Drill), textOf(section.bores, Drill));
    }

    void backDrillsShortenTheWall() {
        const Section section = cut(card(true), {{-20e6, 0}, {20e6, 0}});
        QCOMPARE(textOf(section.pieces, Drill), (QStringList{"19500-19600@1100-2300", "20400-20500@1100-2300"}));
    }

    void cornersAddUp() {
        const Section section = cut(card(), {{-20e6, 0}, {-20e6, 0}, {0, 0}, {0, 20e6}});
        QCOMPARE(section.stations, (std::vector<double>{0.0, 20e6, 40e6}));
        QCOMPARE(textOf(section.pieces, Top), (QStringList{"19000-19500@2200-2300", "20500-21000@2200-2300"}));
        QCOMPARE(textOf(merged(section.pieces), Inner),
                 (QStringList{"10000-19500@1100-1200", "20500-30000@1100-1200"}));
        QVERIFY(textOf(section.pieces, Bottom).empty());
    }

    void slantedLinesMeetTheSame() {
        const Section section = cut(card(), {{-10e6, -10e6}, {10e6, 10e6}});
        QCOMPARE(textOf(section.pieces, Top), (QStringList{"13142-13642@2200-2300", "14642-15142@2200-2300"}));
        QCOMPARE(textOf(section.pieces, Inner).size(), 2);
    }

    void copiesAreCutWhereTheyLie() {
        DocumentBuilder builder;
        addLayers(builder);
        const std::uint32_t step = builder.addStep(card());
        builder.addInstance({step, {{30 * kMm, 0}, 90.0, false}, false});
        builder.addInstance({step, {{60 * kMm, 0}, 0.0, true}, true});
        const Section section = cut(builder.finish(), {{0, 0}, {100e6, 0}});
        // Turned a quarter, the track lies across the line and far from it; turned over, it is on top at 60 - 5 mm.
        QCOMPARE(textOf(section.pieces, Top),
                 (QStringList{"29000-29500@2200-2300", "30500-31000@2200-2300", "54500-55500@2200-2300"}));
        QCOMPARE(textOf(section.pieces, Bottom), (QStringList{"59000-59500@0-100", "60500-61000@0-100"}));
        QCOMPARE(textOf(section.bores, Drill), (QStringList{"29500-30500@0-2300", "59500-60500@0-2300"}));
        QCOMPARE(section.pieces.front().at.copy, 1U);
    }

    /// A part of 2 mm on the top, a hole from there to the inner layer, and layers of bodies of 3 and 1 mm, or none
    /// below.
    void flippedCopiesAreCutAtTheHeightsOfTheOtherSide() {
        for (const Nm tallestBelow : {kMm, Nm{0}}) {
            const std::size_t bodies = Print + 1;
            const std::size_t lieOn = tallestBelow > 0 ? bodies + 1 : bodies;
            const auto add = [&](DocumentBuilder& builder) {
                addLayers(builder);
                builder.layer(LayerId{Bottom}).thickness = 50'000;
                builder.layer(LayerId{Drill}).spanBottom = LayerId{Inner};
                builder.layer(LayerId{Drill}).opposite = {};
                Layer layer;
                layer.type = LayerType::ComponentBody;
                layer.side = LayerSide::Top;
                layer.z = 2'300'000;
                layer.thickness = 3 * kMm;
                layer.opposite = tallestBelow > 0 ? LayerId{lieOn} : LayerId{};
                builder.addLayer(layer);
                layer.side = LayerSide::Bottom;
                layer.z = -tallestBelow;
                layer.thickness = tallestBelow;
                layer.opposite = LayerId{bodies};
                if (tallestBelow > 0) {
                    builder.addLayer(layer);
                }
            };
            DocumentBuilder card;
            add(card);
            Package package;
            package.body = card.addShape(rectangle({-kMm, -kMm}, {kMm, kMm}));
            const ShapeId outline = package.body;
            PackagePin pins[2];
            pins[0] = {{}, PinKind::Surface, {-kMm, 0}, {}};
            pins[1] = {{}, PinKind::Surface, {kMm, 0}, {}};
            Component part;
            part.package = card.addPackage(std::move(package), pins);
            part.height = 2 * kMm;
            const ComponentId component = card.addComponent(std::move(part), {});
            card.beginLayer(LayerId{bodies});
            const ElementId body = card.addArea({outline, {}}, {});
            card.addBody({body, component, 2 * kMm});
            card.beginLayer(LayerId{Top});
            card.addCircle({{0, 0}, 2 * kMm, 0}, {});
            card.beginLayer(LayerId{Drill});
            card.addCircle({{5 * kMm, 0}, kMm, 800'000}, flagged(kHole | kPlated));
            DocumentBuilder panel;
            add(panel);
            panel.addInstance({panel.addStep(card.finish()), {{20 * kMm, 0}, 0.0, true}, true});
            const auto index = indexed(panel.finish());
            const Section solid = *makeSection(*index, {{{0, 0}, {40e6, 0}}, {}, true});
            QCOMPARE(textOf(solid.pieces, Bottom), QStringList{"19000-21000@0-50"});
            QCOMPARE(textOf(solid.pieces, lieOn), QStringList{"19000-21000@-2000-0"});
            QCOMPARE(textOf(solid.bores, Drill), QStringList{"14500-15500@0-1200"});
            for (const SectionPiece& piece : merged(solid.pieces)) {
                const bool hasCounterpart = piece.layer == LayerId{Bottom} || lieOn != bodies;
                QCOMPARE(piece.isMirrored, piece.layer == LayerId{Drill} || !hasCounterpart);
            }
            const Section real = *makeSection(*index, {{{0, 0}, {40e6, 0}}, {}});
            std::size_t pieces = 0;
            for (const SectionPiece& piece : real.pieces) {
                pieces += piece.layer == LayerId{lieOn} ? 1 : 0;
                QVERIFY(piece.layer != LayerId{lieOn} || piece.top <= 0);
            }
            QVERIFY(pieces > 0);
        }
    }

    /// Mask of 20 µm on the top only, and a part on each side: flipped, the mask and the upper part are below.
    void partsOfFlippedCopiesStandOnTheMaskThatIsThere() {
        enum : std::size_t { Mask = Print + 1, BodiesTop, BodiesBottom };
        const auto add = [](DocumentBuilder& builder) {
            addLayers(builder);
            for (const LayerId id : {addLayer(builder, LayerType::SolderMask, LayerSide::Top, 2'300'000, 20'000),
                                     addLayer(builder, LayerType::ComponentBody, LayerSide::Top, 2'300'000, kMm),
                                     addLayer(builder, LayerType::ComponentBody, LayerSide::Bottom, -kMm, kMm)}) {
                builder.layer(id).isSynthetic = true;
            }
            builder.layer(LayerId{BodiesTop}).opposite = LayerId{BodiesBottom};
            builder.layer(LayerId{BodiesBottom}).opposite = LayerId{BodiesTop};
        };
        DocumentBuilder card;
        add(card);
        Package package;
        package.body = card.addShape(rectangle({-kMm, -kMm}, {kMm, kMm}));
        const ShapeId outline = package.body;
        const PackagePin pins[] = {{{}, PinKind::Surface, {-kMm, 0}, {}}, {{}, PinKind::Surface, {kMm, 0}, {}}};
        Component part;
        part.package = card.addPackage(std::move(package), pins);
        part.height = kMm;
        const ComponentId component = card.addComponent(std::move(part), {});
        for (const std::size_t layer : {std::size_t{BodiesTop}, std::size_t{BodiesBottom}}) {
            card.beginLayer(LayerId{layer});
            const ElementId body = card.addArea({outline, {}}, {});
            card.addBody({body, component, kMm});
        }
        DocumentBuilder panel;
        add(panel);
        const std::uint32_t row = panel.addStep(card.finish());
        panel.addInstance({row, {{20 * kMm, 0}, 0.0, true}, true});
        panel.addInstance({row, {{40 * kMm, 0}, 0.0, false}, false});
        const Section section = cut(panel.finish(), {{0, 0}, {60e6, 0}});
        const auto seatOf = [&](std::uint32_t copy, std::size_t layer) {
            Nm seat = layer == BodiesTop ? 5 * kMm : -5 * kMm;  // beyond all
            for (const SectionPiece& piece : section.pieces) {
                if (piece.at.copy == copy && piece.layer == LayerId{layer}) {
                    seat = layer == BodiesTop ? std::min(seat, piece.bottom) : std::max(seat, piece.top);
                }
            }
            return seat;
        };
        QCOMPARE(seatOf(1, BodiesTop), 2'300'000);
        QCOMPARE(seatOf(1, BodiesBottom), -20'000);
        QCOMPARE(seatOf(2, BodiesTop), 2'310'000);
        QCOMPARE(seatOf(2, BodiesBottom), 0);
    }

    void aPanelsOwnHolesPassItsSteps() {
        DocumentBuilder builder;
        addLayers(builder);
        const std::uint32_t step = builder.addStep(card());
        builder.addInstance({step, {{30 * kMm, 0}, 0.0, false}, false});
        builder.beginLayer(LayerId{Drill});
        builder.addCircle({{38 * kMm, 0}, kMm, kMm}, flagged(kHole));
        const Section section = cut(builder.finish(), {{0, 0}, {100e6, 0}});
        QCOMPARE(textOf(section.pieces, Inner),
                 (QStringList{"20000-29500@1100-1200", "30500-37500@1100-1200", "38500-40000@1100-1200"}));
        QCOMPARE(textOf(section.pieces, Drill).size(), 2);  // the bare hole has no wall
    }

    /// As a line along a net has them, whose tracks end in holes.
    void aLegWithinABoreDoesNotMakeItsWallUnknown() {
        const Section section = cut(card(), {{-20e6, 0}, {-100e3, 0}, {100e3, 50e3}, {20e6, 50e3}});
        for (const std::string& note : section.notes) {
            QVERIFY2(note.find("plating thickness") == note.npos, note.c_str());
        }
    }

    void onlyChosenLayersAreCut() {
        std::vector<bool> layers(6, false);
        layers[Inner] = true;
        const Section section = *makeSection(*indexed(card()), {{{-20e6, 0}, {20e6, 0}}, layers});
        QCOMPARE(textOf(section.pieces, Inner), (QStringList{"10000-19500@1100-1200", "20500-30000@1100-1200"}));
        QCOMPARE(section.pieces.size(), std::size_t{2});
    }

    void aRealBoardIsCutWherePickingFindsIt() {
        base::Progress progress;
        const auto board = readBoard(locations::kSample, {}, progress);
        QVERIFY(board);
        const auto index = indexed(*board);
        Picker picker(index);
        std::mt19937 random(3);
        const Box box = (*board)->board;
        std::uniform_int_distribution<Nm> x(box.min.x, box.max.x);
        std::uniform_int_distribution<Nm> y(box.min.y, box.max.y);
        std::size_t compared = 0;
        for (int round = 0; round < 40; ++round) {
            const PointD a = {double(x(random)), double(y(random))};
            const PointD b =
                round % 2 == 0 ? PointD{double(x(random)), a.y} : PointD{double(x(random)), double(y(random))};
            const Section section = *makeSection(*index, {{a, b}, {}, true});
            for (int i = 0; i < 25; ++i) {
                const double part = std::uniform_real_distribution<>(0.0, 1.0)(random);
                const double location = section.stations.back() * part;
                std::set<BoardElement> cut = elementsAt(section.pieces, location);
                if (isAtAnEnd(section, location) || !elementsAt(section.bores, location).empty()) {
                    continue;
                }
                QCOMPARE(cut, elementsUnder(picker, {a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part}));
                compared += cut.size();
            }
        }
        QVERIFY(compared > 1000);
    }

    void drawingsAreToScale() {
        const auto board = card();
        const Section section = cut(board, {{-20e6, 0}, {20e6, 0}});
        SectionPicture how{std::vector<std::uint32_t>(6, 0x123456), 4.0};
        SectionDimension dimension{{10e6, 100e3, true, true}, {30e6, 100e3, true, true}};
        how.dimensions.push_back({dimension, "20 mm (787 mil)"});
        const QString svg = QString::fromStdString(sectionSvg(*board, section, how));
        QVERIFY(svg.contains("Scale 5 : 1, heights 4 times larger"));
        // A unit is a millimetre of paper.
        const auto match =
            QRegularExpression("width=\"([0-9.]+)mm\" height=\"([0-9.]+)mm\" viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"")
                .match(svg);
        QVERIFY(match.hasMatch());
        QCOMPARE(match.captured(1), match.captured(3));
        QCOMPARE(match.captured(2), match.captured(4));
        // The track: 1 mm of 40 mm, five times; 0.1 mm high, twenty times.
        QVERIFY2(svg.contains("M130.5000,72.0000 135.5000,72.0000 135.5000,70.0000 130.5000,70.0000z"),
                 qPrintable(svg));
        QVERIFY(svg.contains(">20 mm (787 mil)</text>"));
        QVERIFY(svg.contains(QString("M%1 ").arg(8.0 + 50.0, 0, 'f', 4)));  // the dimension begins at 10 mm
        how.scale = 1.0;
        QVERIFY(QString::fromStdString(sectionSvg(*board, section, how)).contains("Scale 1 : 1"));
    }

    void tablesListEveryPiece() {
        const auto index = indexed(card());
        const Section section = *makeSection(*index, {{{-20e6, 0}, {20e6, 0}}, {}});
        const QStringList lines = QString::fromStdString(sectionCsv(*index, section)).split("\r\n", Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(1 + section.pieces.size() + section.bores.size()));
        QCOMPARE(lines[1],
                 "solid,top,0,0,,19000000.000,19500000.000,2200000,2300000,19000000.000,19500000.000,copper,,");
        QVERIFY(lines[0].endsWith(",material,dielectric,dielectric_thickness_nm"));
        QVERIFY(lines.last().startsWith("bore,drill,0,3,"));
    }

    void linesThatCannotBeCutAlongAreRefused() {
        const auto index = indexed(card());
        for (const std::vector<PointD>& line :
             {std::vector<PointD>{}, {{1, 1}}, {{1, 1}, {1, 1}}, {{0, 0}, {2e9, 0}}, {{0, 0}, {std::nan(""), 0}}}) {
            const auto section = makeSection(*index, {line, {}});
            QVERIFY(!section);
            QCOMPARE(section.error().code, base::ErrorCode::BadUsage);
        }
        QVERIFY(!makeSection(*index, {std::vector<PointD>(kMostCorners + 1), {}}));
    }

    void aLineBesideTheBoardSaysSo() {
        const Section section = cut(card(), {{50e6, 0}, {60e6, 0}});
        QVERIFY(section.pieces.empty());
        QCOMPARE(section.notes, std::vector<std::string>{"the line meets nothing of the board"});
    }

    void platedHolesWithoutAKnownWallAreNamed() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Drill});
        builder.addArea({builder.addShape(rectangle({-kMm, -kMm}, {kMm, kMm})), {}}, flagged(kHole | kPlated));
        const auto board = builder.finish();
        const Section section = cut(board, {{-5e6, 0}, {5e6, 0}});
        QVERIFY(section.pieces.empty());
        QCOMPARE(textOf(section.bores, Drill), (QStringList{"4000-6000@0-2300"}));
        QCOMPARE(section.notes,
                 (std::vector<std::string>{"plated holes without a known plating thickness, drawn without it: 1"}));
        QVERIFY(cut(board, {{-5e6, 2e6}, {5e6, 2e6}}).notes.front().starts_with("the line meets nothing"));
    }

    void missingThicknessesAreNamed() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.layer(LayerId{Top}).thicknessSource = Source::Assumed;
        builder.beginLayer(LayerId{Top});
        builder.addCircle({{0, 0}, kMm, 0}, {});
        builder.beginLayer(LayerId{Print});
        builder.addCircle({{0, 0}, kMm, 0}, {});
        const Section section = cut(builder.finish(), {{-1e6, 0}, {1e6, 0}});
        QCOMPARE(textOf(section.pieces, Print), (QStringList{"500-1500@2300-2300"}));
        QCOMPARE(section.notes,
                 (std::vector<std::string>{"without a thickness, drawn as a line: print", "thickness assumed: top"}));
    }
};

QTEST_APPLESS_MAIN(SectionTest)
#include "section_test.moc"
