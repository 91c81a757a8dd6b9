#include "model/formats/drawing/assembly.h"

#include <QtTest>
#include <algorithm>

#include "tests/unit/model/formats/drawing/drawn_testing.h"

using namespace drawn_testing;
using model::Document;
using model::ElementId;
using model::ElementKind;
using model::LayerId;
using model::LayerSide;
using model::Plating;
using model::SubnetKind;

namespace {

model::NetId netOf(const Document& d, ElementId id) {
    return d.elements.net[id.row()];
}

const model::Subnet& subnetOf(const Document& d, ElementId id) {
    return d.subnets[d.elements.subnet[id.row()].row()];
}

/// A component R1 with two pins 4 mm apart, on SIG and GND, its pads on TOP.
DrawnJob boardWithAPart() {
    DrawnJob job = boardOfTwoLayers();
    DrawnStep& step = job.steps[0];
    const std::int32_t round = addRound(step, kMm);
    step.packages.push_back({"0805", 4 * kMm, {}, {}, {{"1", {}, mm(-2, 0), {}}, {"2", {}, mm(2, 0), {}}}, {}});
    DrawnComponent part;
    part.refdes = "R1";
    part.part = "10k";
    part.package = 0;
    part.position = mm(20, 20);
    part.pins = {{"1", mm(18, 20), 1, 0}, {"2", mm(22, 20), 0, 1}};
    part.properties = {{"value", "10k"}};
    part.line = 7;
    step.components.push_back(part);
    for (const std::int32_t pin : {0, 1}) {
        DrawnFeature feature = pad(round, step.components[0].pins[static_cast<std::size_t>(pin)].position, 1 - pin);
        feature.component = 0;
        feature.pin = pin;
        draw(step, 0, feature);
    }
    return job;
}

}  // namespace

class AssemblyTest : public QObject {
    Q_OBJECT

private slots:
    void tracksAreJoinedAndKeepTheirNet() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        const std::int32_t pen = addRound(step, 200'000);
        draw(step, 0, line(pen, mm(1, 1), mm(5, 1), 1)).subnet = SubnetKind::Trace;
        draw(step, 0, line(pen, mm(5, 1), mm(5, 9), 1)).subnet = SubnetKind::Trace;
        draw(step, 0, line(pen, mm(5, 9), mm(9, 9), 0)).subnet = SubnetKind::Trace;
        const auto d = assembled(job);
        QCOMPARE(d->layer(LayerId{0}).elements.count, 2U);
        QCOMPARE(d->layer(LayerId{0}).featureCount, 3U);
        const ElementId trail = elementOf(*d, "TOP", 0);
        QCOMPARE(d->elements.kind[trail.row()], ElementKind::Trail);
        QCOMPARE(d->nets[netOf(*d, trail).row()].name, std::string("SIG"));
        QCOMPARE(subnetOf(*d, trail).kind, SubnetKind::Trace);
        QCOMPARE(d->nets[netOf(*d, elementOf(*d, "TOP", 1)).row()].name, std::string("GND"));
        QCOMPARE(d->symbols[d->elements.symbol[trail.row()].row()], std::string("r200"));
        QCOMPARE(d->elements.line[trail.row()], 1U);
    }

    void anArcKeepsItsDirectionAndARegionIsSharedByItsPlacements() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        DrawnFeature arc = line(addRound(step, 200'000), mm(10, 10), mm(20, 10));
        arc.kind = DrawnKind::Arc;
        arc.centre = mm(15, 10);
        arc.isClockwise = true;
        draw(step, 0, arc);
        DrawnFeature area = region(addRegion(step, box(mm(0, 0), mm(4, 2))));
        area.a = mm(30, 30);
        draw(step, 0, area);
        area.a = mm(50, 30);
        area.clockwiseDeg = 90.0;
        draw(step, 0, area);
        const auto d = assembled(job);
        QVERIFY(d->arcs[0].node.edge == model::EdgeKind::ArcClockwise);
        const model::Box arcBox = d->boxOf(elementOf(*d, "TOP", 0));
        QVERIFY(arcBox.max.y > 15 * kMm && arcBox.min.y > 9 * kMm);  // over the top from left to right
        QCOMPARE(d->areas[0].shape, d->areas[1].shape);
        QCOMPARE(d->boxOf(elementOf(*d, "TOP", 1)), (model::Box{mm(30, 30), mm(34, 32)}));
        QCOMPARE(d->boxOf(elementOf(*d, "TOP", 2)), (model::Box{mm(50, 26), mm(52, 30)}));
    }

    void negativeFeaturesTakeAwayWhatLiesBeforeThem() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        draw(step, 0, region(addRegion(step, box(mm(10, 10), mm(20, 20)))));
        draw(step, 0, region(addRegion(step, box(mm(15, 0), mm(30, 30))))).isNegative = true;
        draw(step, 0, region(addRegion(step, box(mm(18, 18), mm(19, 19)))));
        const auto d = assembled(job);
        QCOMPARE(d->layer(LayerId{0}).elements.count, 2U);
        QCOMPARE(d->boxOf(elementOf(*d, "TOP", 0)), (model::Box{mm(10, 10), mm(15, 20)}));
        QCOMPARE(d->boxOf(elementOf(*d, "TOP", 1)), (model::Box{mm(18, 18), mm(19, 19)}));
    }

    void aNegativeLayerIsTheBoardWithoutItsFeatures() {
        DrawnJob job = boardOfTwoLayers();
        job.layers[1].isNegative = true;
        DrawnStep& step = job.steps[0];
        const std::int32_t pen = addRound(step, 2 * kMm);
        draw(step, 1, line(pen, mm(50, -5), mm(50, 55)));
        DrawnFeature hole = pad(addRound(step, 500'000), mm(20, 20), 0);
        hole.plating = Plating::Via;
        draw(step, 2, hole);
        const auto d = assembled(job);
        const model::Layer& layer = d->layer(LayerId{1});
        QCOMPARE(layer.elements.count, 2U);
        int withNet = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const ElementId id = elementOf(*d, "BOTTOM", i);
            const bool isLeft = d->boxOf(id).max.x == 49 * kMm;
            QVERIFY(isLeft || d->boxOf(id).min.x == 51 * kMm);
            QCOMPARE(netOf(*d, id).isValid(), isLeft);
            withNet += netOf(*d, id).isValid() ? 1 : 0;
        }
        QCOMPARE(withNet, 1);
        QVERIFY(findMessage(*d, "1 of 2 pieces have a net") != nullptr);
    }

    void messagesOnNegativeLayersHaveTheLineOfTheLayer() {
        DrawnJob job = boardOfTwoLayers();
        job.layers[1].isNegative = true;
        job.layers[1].line = 7;
        draw(job.steps[0], 1, pad(addRound(job.steps[0], kMm), mm(20, 20)));
        const auto d = assembled(job);
        const model::Diagnostic* message = findMessage(*d, "Layer BOTTOM is negative");
        QVERIFY(message != nullptr);
        QCOMPARE(message->file, std::string("job.txt"));
        QCOMPARE(message->line, 7U);
    }

    void negativeLayersKeepTheirOrder() {
        DrawnJob job = boardOfTwoLayers();
        job.layers[0].isNegative = job.layers[1].isNegative = true;
        DrawnStep& step = job.steps[0];
        const std::int32_t pen = addRound(step, 2 * kMm);
        draw(step, 0, line(pen, mm(30, -5), mm(30, 55)));
        draw(step, 1, line(pen, mm(50, -5), mm(50, 55)));
        const auto d = assembled(job);
        const model::Layer& top = d->layer(LayerId{0});
        const model::Layer& bottom = d->layer(LayerId{1});
        QCOMPARE(top.elements.count, 2U);
        QCOMPARE(bottom.elements.count, 2U);
        QCOMPARE(bottom.elements.first, top.elements.first + 2);
        const auto edgeOfLeft = [&](const char* layer) {
            return std::min(d->boxOf(elementOf(*d, layer, 0)).max.x, d->boxOf(elementOf(*d, layer, 1)).max.x);
        };
        QCOMPARE(edgeOfLeft("TOP"), 29 * kMm);
        QCOMPARE(edgeOfLeft("BOTTOM"), 49 * kMm);
        QVERIFY(findMessage(*d, "Layer TOP is negative") != nullptr);
        QVERIFY(findMessage(*d, "Layer BOTTOM is negative") != nullptr);
    }

    void holesHaveTheirSpanPlatingAndPurpose() {
        DrawnJob job = boardOfTwoLayers();
        job.layers.insert(job.layers.begin() + 1, DrawnLayer());
        job.layers[1].name = "IN1";
        job.layers[1].type = LayerType::PowerGround;
        DrawnLayer& blind = job.layers.emplace_back();
        blind.name = "BLIND";
        blind.type = LayerType::Drill;
        blind.spanTop = 1;
        blind.spanBottom = 0;
        model::DrillTool tool;
        tool.finishedSize = 200'000;
        tool.drillSize = 260'000;
        blind.tools.push_back(tool);
        DrawnStep& step = job.steps[0];
        DrawnFeature via = pad(addRound(step, 200'000), mm(5, 5), 1);
        via.plating = Plating::Plated;
        via.subnet = SubnetKind::Via;
        draw(step, 4, via);
        DrawnFeature slot = line(addRound(step, kMm), mm(10, 10), mm(12, 10));
        slot.plating = Plating::NonPlated;
        draw(step, 3, slot);
        DrawnFeature milled = region(addRegion(step, box(mm(30, 30), mm(33, 31))));
        milled.plating = Plating::Plated;
        draw(step, 3, milled);
        const auto d = assembled(job);
        QVERIFY(d->layer(d->findLayer("BLIND")).spanTop == d->findLayer("TOP"));
        QVERIFY(d->layer(d->findLayer("BLIND")).spanBottom == d->findLayer("IN1"));
        QVERIFY(d->layer(d->findLayer("DRILL")).spanBottom == d->findLayer("BOTTOM"));
        const ElementId viaHole = elementOf(*d, "BLIND", 0);
        QCOMPARE(model::holeKind(d->elements.flags[viaHole.row()]), model::HoleKind::Via);
        QCOMPARE(d->circles[0].diameter, 260'000);
        QCOMPARE(d->circles[0].innerDiameter, 200'000);
        QVERIFY(d->tools[0].layer == d->findLayer("BLIND"));
        QCOMPARE(model::holeKind(d->elements.flags[elementOf(*d, "DRILL", 0).row()]), model::HoleKind::NonPlated);
        QCOMPARE(model::holeKind(d->elements.flags[elementOf(*d, "DRILL", 1).row()]), model::HoleKind::Plated);
    }

    void layersTheBoardIsMadeOfComeFirstAndHaveOpposites() {
        DrawnJob job;
        addLayer(job, "notes", LayerType::Document);
        addLayer(job, "mask top", LayerType::SolderMask);
        addLayer(job, "TOP", LayerType::Signal);
        addLayer(job, "core", LayerType::Dielectric);
        addLayer(job, "BOTTOM", LayerType::Signal);
        addLayer(job, "mask bottom", LayerType::SolderMask);
        job.layers[3].facts.thicknessNm = 1'000'000;
        job.layers[2].facts.thicknessNm = job.layers[4].facts.thicknessNm = 35'000;
        job.steps.emplace_back().profile = box(mm(0, 0), mm(10, 10));
        const auto d = assembled(job);
        QCOMPARE(d->layers[0].name, std::string("mask top"));
        QCOMPARE(d->layers[5].name, std::string("notes"));
        QCOMPARE(d->boardThickness, 1'070'000);
        QCOMPARE(d->layers[0].opposite, d->findLayer("mask bottom"));
        QVERIFY(d->layers[1].side == LayerSide::Top);
        QVERIFY(d->layers[4].side == LayerSide::Bottom);
        QCOMPARE(d->layers[1].thicknessSource, model::Source::Job);
        QVERIFY(findMessage(*d, "on which nothing is drawn: mask top, TOP") != nullptr);
    }

    void padsOfPinsAreTiedToThem() {
        const auto d = assembled(boardWithAPart());
        QCOMPARE(d->components.size(), std::size_t{1});
        QCOMPARE(d->pins.size(), std::size_t{2});
        QCOMPARE(d->text(d->pins[1].name), std::string("2"));
        QCOMPARE(d->nets[d->pins[0].net.row()].name, std::string("SIG"));
        QCOMPARE(d->pins[1].packagePin, 1U);
        for (std::size_t pin = 0; pin < 2; ++pin) {
            const ElementId id = elementOf(*d, "TOP", pin);
            QCOMPARE(subnetOf(*d, id).kind, SubnetKind::PinPads);
            QCOMPARE(subnetOf(*d, id).pin, model::PinId{pin});
        }
        QCOMPARE(d->text(d->propertiesOf(d->components[0].properties)[0].value), std::string("10k"));
        QVERIFY(!d->components[0].placement.isMirrored);
        QVERIFY(findMessage(*d, "do not lie where") == nullptr);
    }

    void mirroringFollowsFromThePins() {
        DrawnJob job = boardWithAPart();
        std::swap(job.steps[0].components[0].pins[0].position, job.steps[0].components[0].pins[1].position);
        auto d = assembled(job);
        QVERIFY(d->components[0].placement.isMirrored);
        job.steps[0].components[0].isMirrored = false;  // what the job says holds, and what does not fit is told
        d = assembled(job);
        QVERIFY(!d->components[0].placement.isMirrored);
        const model::Diagnostic* message = findMessage(*d, "do not lie where its package puts them");
        QVERIFY(message != nullptr);
        QCOMPARE(message->file, std::string("parts.txt"));
        QCOMPARE(message->line, 7U);
        QCOMPARE(*message->location, mm(20, 20));
    }

    void aViaIsOneSubnetOnAllItsLayers() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        const std::int32_t round = addRound(step, 600'000);
        for (const std::int32_t layer : {0, 1, 2}) {
            DrawnFeature feature = pad(round, mm(5, 5), 1);
            feature.subnet = SubnetKind::Via;
            draw(step, layer, feature);
            feature.a = mm(8, 8);
            draw(step, layer, feature);
        }
        const auto d = assembled(job);
        QCOMPARE(d->subnets.size(), std::size_t{2});
        QCOMPARE(d->elements.subnet[elementOf(*d, "TOP", 0).row()],
                 d->elements.subnet[elementOf(*d, "DRILL", 0).row()]);
        QVERIFY(d->elements.subnet[elementOf(*d, "TOP", 0).row()] != d->elements.subnet[elementOf(*d, "TOP", 1).row()]);
    }

    void badRowsAreReportedWithTheirLine() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        const std::int32_t round = addRound(step, kMm);
        draw(step, 0, pad(round, mm(1, 1), 7));
        draw(step, 0, pad(3, mm(2, 2)));
        draw(step, 0, region(0));
        DrawnFeature ofPin = pad(round, mm(3, 3), 0);
        ofPin.component = 0;
        ofPin.pin = 0;
        ofPin.attributes = 5;
        draw(step, 0, ofPin);
        step.groups.push_back({"TEXT", {}, {{0, 0}, {0, 9}, {-1, 0}}});
        job.layers[2].spanTop = 2;
        const auto d = assembled(job);
        QCOMPARE(d->layer(LayerId{0}).elements.count, 2U);
        const auto lineOf = [&](const char* text) { return findMessage(*d, text) ? findMessage(*d, text)->line : 0; };
        QCOMPARE(lineOf("names a net that is not there"), 1U);
        QCOMPARE(lineOf("names a symbol that is not there"), 2U);
        QCOMPARE(lineOf("names a region that is not there"), 3U);
        QCOMPARE(lineOf("names a pin that is not there"), 4U);
        QCOMPARE(lineOf("names attributes that are not there"), 4U);
        QCOMPARE(findMessage(*d, "names a net that is not there")->element, elementOf(*d, "TOP", 0));
        QCOMPARE(findMessage(*d, "group names a feature")->count, 2U);
        QCOMPARE(d->groupElements.size(), std::size_t{1});
        QVERIFY(findMessage(*d, "its span ends at what is no copper layer") != nullptr);
    }

    void aMessageOfTheReaderPointsToTheElementOfItsLine() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        const std::int32_t round = addRound(step, kMm);
        draw(step, 0, pad(round, mm(1, 1)));
        draw(step, 1, pad(round, mm(2, 1)));
        job.diagnostics.report(model::Severity::Warning, "job.txt", 101, "odd");
        job.diagnostics.report(model::Severity::Warning, "job.txt", 99, "odder");
        const auto d = assembled(job);
        QCOMPARE(findMessage(*d, "Odd")->element, elementOf(*d, "BOTTOM", 0));
        QVERIFY(!findMessage(*d, "Odder")->element.isValid());
    }

    void aBoardWithoutAProfileHasTheBoxOfItsCopper() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        step.profile = {};
        draw(step, 0, region(addRegion(step, box(mm(10, 10), mm(20, 30)))));
        const auto d = assembled(job);
        QCOMPARE(d->board, (model::Box{mm(10, 10), mm(20, 30)}));
        QVERIFY(findMessage(*d, "draws no outline of the board; the box around all copper") != nullptr);
        QVERIFY(d->profileSource == model::Source::Assumed);
    }

    void copiesAreLaidOutAndBadOnesLeftOut() {
        DrawnJob job = boardOfTwoLayers();
        const std::int32_t round = addRound(job.steps[0], kMm);
        draw(job.steps[0], 0, pad(round, mm(1, 1)));
        DrawnStep panel;
        panel.name = "panel";
        panel.copiesFile = "panel.txt";
        panel.profile = box(mm(0, 0), mm(300, 100));
        panel.copies.push_back({1, {mm(10, 10), 0.0, false}, false, 1});
        panel.copies.push_back({1, {mm(290, 10), 0.0, true}, true, 2});
        panel.copies.push_back({0, {}, false, 3});
        panel.copies.push_back({4, {}, false, 4});
        panel.copies.push_back({1, {mm(1070, 0), 0.0, false}, false, 5});
        job.steps.insert(job.steps.begin(), panel);
        const auto d = assembled(job);
        QCOMPARE(d->steps.size(), std::size_t{1});
        QCOMPARE(d->instances.size(), std::size_t{2});
        QCOMPARE(d->steps[0]->job.step, std::string("board"));
        QCOMPARE(d->job.step, std::string("panel"));
        QCOMPARE(d->layer(LayerId{0}).countsWithCopies[static_cast<std::size_t>(ElementKind::Circle)], 1U);
        QCOMPARE(d->layer(LayerId{1}).countsWithCopies[static_cast<std::size_t>(ElementKind::Circle)], 1U);
        const model::Diagnostic* missing = findMessage(*d, "copy of a step that is not there");
        QCOMPARE(missing != nullptr ? missing->count : 0, 2U);
        QCOMPARE(findMessage(*d, "outside of the coordinate range")->line, 5U);
    }

    void zonesBoundTheLayersThatOnlySomeOfThemHave() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        step.zones.push_back({"rigid", {0, 1}, box(mm(0, 0), mm(40, 50))});
        step.zones.push_back({"rigid 2", {0, 1}, box(mm(40, 0), mm(60, 50))});
        step.zones.push_back({"flex", {1, 9}, box(mm(60, 0), mm(100, 50))});
        const auto d = assembled(job);
        QCOMPARE(d->zones.size(), std::size_t{3});
        const model::Layer& top = d->layer(LayerId{0});
        QVERIFY(top.profile.isValid() && top.outlineGroup == 1);
        QCOMPARE(d->shapes.shapes[top.profile.row()].box, (model::Box{mm(0, 0), mm(60, 50)}));
        QVERIFY(!d->layer(LayerId{1}).profile.isValid());
        QVERIFY(findMessage(*d, "zone names a layer that is not there") != nullptr);
    }

    void netlistsAreComparedWithTheNets() {
        DrawnJob job = boardOfTwoLayers();
        DrawnStep& step = job.steps[0];
        draw(step, 0, pad(addRound(step, kMm), mm(5, 5), 0));
        DrawnNetlist list;
        list.file = "board.d356";
        list.netlist.names = {"GND"};
        NetlistPoint point;
        point.position = mm(5, 5);
        point.number = 0;
        point.side = LayerSide::Top;
        list.netlist.points.push_back(point);
        step.netlists.push_back(list);
        const auto d = assembled(job);
        QCOMPARE(d->netPoints.size(), std::size_t{1});
        QCOMPARE(d->nets[d->netPoints[0].net.row()].name, std::string("GND"));
        QVERIFY(d->netPoints[0].netlist == model::NetlistKind::Reference);
    }

    void nothingAtAllIsABoardToo() {
        const auto d = assembled(DrawnJob());
        QCOMPARE(d->elements.size(), std::size_t{0});
        QCOMPARE(d->job.steps.size(), std::size_t{1});
    }

    void cancellingEndsIt() {
        base::Progress progress;
        progress.cancel();
        const auto result = assemble(boardWithAPart(), 0.0, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(AssemblyTest)
#include "assembly_test.moc"
