#include "model/agreement/agreement.h"

#include <QtTest>
#include <numbers>

#include "model/agreement/layer_agreement.h"
#include "tests/unit/model/formats/drawing/drawn_testing.h"

using namespace drawn_testing;
using model::Accord;
using model::Agreement;
using model::AgreementRequest;
using model::Aspect;
using model::Comparison;

namespace {

/// Two parts, tracks and vias of two nets, and solder mask on both sides.
DrawnJob board() {
    DrawnJob job = boardOfTwoLayers();
    addLayer(job, "MASK TOP", LayerType::SolderMask);
    std::swap(job.layers[3], job.layers[0]);  // mask, bottom … in physical order
    std::swap(job.layers[3], job.layers[1]);
    std::swap(job.layers[3], job.layers[2]);  // MASK TOP, TOP, BOTTOM, DRILL
    DrawnStep& step = job.steps[0];
    const std::int32_t pen = addRound(step, 200'000);
    const std::int32_t round = addRound(step, kMm);
    const std::int32_t drill = addRound(step, 300'000);
    for (const int row : {0, 1}) {
        DrawnComponent part;
        part.refdes = row == 0 ? "R1" : "R2";
        part.position = mm(20 + 30 * row, 20);
        part.pins = {{"1", mm(18 + 30 * row, 20), 0, kNoRow}, {"2", mm(22 + 30 * row, 20), 1, kNoRow}};
        for (const DrawnPin& pin : part.pins) {
            DrawnFeature land = pad(round, pin.position, pin.net);
            land.component = row;
            land.pin = pin.net;
            draw(step, 1, land);
            draw(step, 0, pad(round, pin.position));
        }
        step.components.push_back(part);
    }
    draw(step, 1, line(pen, mm(18, 20), mm(48, 20), 0));
    draw(step, 1, line(pen, mm(22, 30), mm(52, 30), 1));
    DrawnFeature via = pad(drill, mm(30, 20), 0);
    via.plating = model::Plating::Via;
    draw(step, 3, via);
    via.a = mm(40, 30);
    via.net = 1;
    draw(step, 3, via);
    return job;
}

Agreement compared(const DrawnJob& a, const DrawnJob& b, const AgreementRequest& request = {}) {
    base::Progress progress;
    return *compareBoards(*assembled(a), *assembled(b), request, progress);
}

const Comparison* find(const Agreement& agreement, Aspect aspect) {
    const auto found = std::ranges::find(agreement.comparisons, aspect, &Comparison::aspect);
    return found == agreement.comparisons.end() ? nullptr : &*found;
}

/// What the comparison of an aspect says first; empty if it agrees.
std::string firstOf(const Agreement& agreement, Aspect aspect) {
    const Comparison* comparison = find(agreement, aspect);
    return comparison == nullptr || comparison->differences.empty() ? "" : comparison->differences[0].text;
}

/// All that differ.
std::vector<Aspect> differing(const Agreement& agreement) {
    std::vector<Aspect> aspects;
    for (const Comparison& comparison : agreement.comparisons) {
        if (comparison.accord == Accord::Differ) {
            aspects.push_back(comparison.aspect);
        }
    }
    return aspects;
}

using Aspects = std::vector<Aspect>;

void moveAll(DrawnJob& job, Point by) {
    const auto move = [by](Point& point) { point = {point.x + by.x, point.y + by.y}; };
    DrawnStep& step = job.steps[0];
    for (auto& layer : step.features) {
        for (DrawnFeature& feature : layer) {
            move(feature.a);
            move(feature.b);
        }
    }
    for (DrawnComponent& part : step.components) {
        move(part.position);
        for (DrawnPin& pin : part.pins) {
            move(pin.position);
        }
    }
    step.profile = box(by, {100 * kMm + by.x, 50 * kMm + by.y});
}

}  // namespace

class AgreementTest : public QObject {
    Q_OBJECT

private slots:
    void aBoardAgreesWithItself() {
        DrawnJob job = board();
        job.boardNm = 1.6e6;
        const Agreement agreement = compared(job, job);
        QVERIFY(agreement.isAgreed());
        QCOMPARE(agreement.shift, Point());
        QCOMPARE(agreement.comparisons.size(), std::size_t{9});  // TOP, MASK TOP, outline, holes … stackup
        for (const Comparison& comparison : agreement.comparisons) {
            QVERIFY2(comparison.accord == Accord::Agree, toString(comparison.aspect));
        }
    }

    void aMovedTrackIsSaidWithItsLayer() {
        DrawnJob other = board();
        other.steps[0].features[1][4].b = mm(48, 21);
        const Agreement agreement = compared(board(), other);
        QVERIFY(!agreement.isAgreed());
        QCOMPARE(differing(agreement), (Aspects{Aspect::Copper}));
        const Comparison& copper = *find(agreement, Aspect::Copper);
        QCOMPARE(copper.layers[0], std::string("TOP"));
        QVERIFY(copper.region->only[0] > 0.0 && copper.region->only[1] > 0.0);
        AgreementRequest lenient;
        lenient.allowed = 1.0;
        QVERIFY(compared(board(), other, lenient).isAgreed());
        AgreementRequest others;
        others.aspects = {Aspect::Holes, Aspect::SolderMask};
        QVERIFY(compared(board(), other, others).isAgreed());
    }

    void whatDiffersIsDrawnByItsPlace() {
        DrawnJob other = board();
        const std::int32_t pen = addRound(other.steps[0], 200'000);
        draw(other.steps[0], 1, line(pen, mm(70, 40), mm(80, 40), 0));
        moveAll(other, {2 * kMm, kMm});
        const auto a = assembled(board());
        const auto b = assembled(other);
        base::Progress progress;
        const Agreement agreement = *compareBoards(*a, *b, {}, progress);
        const Comparison& copper = *find(agreement, Aspect::Copper);
        QCOMPARE(copper.differing, std::size_t{1});
        const model::Box place = copper.differences[0].box.grownBy(50'000);
        QVERIFY(place.holds(mm(70, 40)) && place.holds(mm(80, 40)) && !place.holds(mm(52, 30)));
        const auto [ours, theirs] = onlyDrawn(*a, *b, agreement.shift, copper.pair, place);
        QVERIFY(ours.polygons.empty());
        QCOMPARE(theirs.polygons.size(), std::size_t{1});
        const double exact = 2.0 * (2e5 * 1e7 + std::numbers::pi * 1e10);  // twice the area, of a capsule
        QVERIFY(std::abs(static_cast<double>(twiceArea(theirs)) - exact) < 0.01 * exact);
        // All of the layer, and a layer that only one of them has.
        const model::Box all{{0, 0}, {100 * kMm, 50 * kMm}};
        QCOMPARE(onlyDrawn(*a, *b, agreement.shift, copper.pair, all)[1].polygons.size(), std::size_t{1});
        const auto alone = onlyDrawn(*a, *b, agreement.shift, {Aspect::Copper, copper.pair.a, {}}, all);
        QVERIFY(!alone[0].polygons.empty() && alone[1].polygons.empty());
        const auto outlines = onlyDrawn(*a, *b, {}, {Aspect::Outline, {}, {}}, all);
        QCOMPARE(static_cast<double>(twiceArea(outlines[0])), 2.0 * (2e6 * 50e6 + 98e6 * 1e6));
    }

    void holesAreComparedOneByOne() {
        DrawnJob other = board();
        other.steps[0].features[3][0].plating = model::Plating::NonPlated;
        QCOMPARE(firstOf(compared(board(), other), Aspect::Holes),
                 std::string("a hole of 0.300 mm is plated in A, not plated in B"));
        other = board();
        other.steps[0].symbols[2].shape.width = other.steps[0].symbols[2].shape.height = 350'000;
        QCOMPARE(firstOf(compared(board(), other), Aspect::Holes),
                 std::string("a hole is 0.300 mm in A, 0.350 mm in B"));
        other = board();
        other.layers[3].spanBottom = 1;
        other.layers[3].spanTop = 1;
        QCOMPARE(firstOf(compared(board(), other), Aspect::Holes),
                 std::string("a hole of 0.300 mm passes copper 1 to 2 in A, copper 1 to 1 in B"));
        other = board();
        other.steps[0].features[3][0].a.x += 300'001;  // its width, and no longer near
        const Agreement agreement = compared(board(), other);
        QCOMPARE(find(agreement, Aspect::Holes)->differing, std::size_t{2});
        QCOMPARE(firstOf(agreement, Aspect::Holes), std::string("only A has a plated hole of 0.300 mm"));
        QCOMPARE(*find(agreement, Aspect::Holes)->differences[0].location, mm(30, 20));
        other.steps[0].features[3][0].a.x -= 299'501;
        const Agreement near = compared(board(), other);
        QVERIFY(near.isAgreed());
        QCOMPARE(find(near, Aspect::Holes)->farthest, std::optional(500.0));
    }

    /// A drill file in inches has four decimals: 0.3 mm are 0.0118 inch there, which is 0.29972 mm.
    void holesMayBeRoundedAsDrillFilesInInchesAre() {
        DrawnJob exact = board();
        moveAll(exact, {300, 300});
        DrawnJob other = exact;
        const auto resize = [&other](Nm size) {
            other.steps[0].symbols[2].shape.width = other.steps[0].symbols[2].shape.height = size;
        };
        resize(304'800);  // 0.012 inch
        other.steps[0].features[3][0].a.x += 1'200;
        QCOMPARE(firstOf(compared(exact, other), Aspect::Holes), std::string("a hole is 0.300 mm in A, 0.305 mm in B"));
        resize(299'720);
        const Agreement rounded = compared(exact, other);
        QVERIFY(rounded.isAgreed());
        QCOMPARE(find(rounded, Aspect::Holes)->farthest, std::optional(1'200.0));
        resize(299'800);  // no number that is rounded so
        QCOMPARE(find(compared(exact, other), Aspect::Holes)->differing, std::size_t{1});
    }

    void holesAreMovedWhereOneLikeThemIsNear() {
        DrawnJob other = board();
        other.steps[0].features[3][0].a.x += 10'000;
        const Agreement agreement = compared(board(), other);
        QCOMPARE(find(agreement, Aspect::Holes)->differing, std::size_t{1});
        QCOMPARE(firstOf(agreement, Aspect::Holes), std::string("a plated hole of 0.300 mm is moved by 0.0100 mm"));
        QCOMPARE(*find(agreement, Aspect::Holes)->differences[0].location, mm(30, 20));
        QCOMPARE(find(agreement, Aspect::Holes)->farthest, std::optional(10'000.0));
        other.steps[0].features[3][0].plating = model::Plating::NonPlated;
        QCOMPARE(find(compared(board(), other), Aspect::Holes)->differing, std::size_t{2});
    }

    void partsAndPinsAreComparedByName() {
        DrawnJob other = board();
        DrawnStep& step = other.steps[0];
        step.components[0].position.x += 50'000;
        step.components[1].clockwiseDeg = 90.0;
        step.components[1].pins[0].name = "A";
        DrawnComponent bare;
        bare.refdes = "LOGO";
        step.components.push_back(bare);
        const Agreement agreement = compared(board(), other);
        QCOMPARE(differing(agreement), (Aspects{Aspect::Parts, Aspect::Pins}));
        const Comparison& parts = *find(agreement, Aspect::Parts);
        QCOMPARE(parts.differences[0].text, std::string("R1 is moved by 0.0500 mm"));
        QCOMPARE(parts.differences[1].text, std::string("R2 is turned by 0.00 degrees in A, by 90.00 in B"));
        QCOMPARE(parts.differing, std::size_t{2});
        QVERIFY(parts.note.find("1 part without pins is") == 0);
        QCOMPARE(parts.farthest, std::optional(50'000.0));
        QCOMPARE(find(agreement, Aspect::Pins)->farthest, std::optional(0.0));
        QVERIFY(!find(agreement, Aspect::Nets)->farthest);
        QCOMPARE(firstOf(agreement, Aspect::Pins), std::string("R2.1 is called A in B"));
        step.components[1].pins[0].name.clear();  // a format that has no name for it
        QVERIFY(find(compared(board(), other), Aspect::Pins)->accord == Accord::Agree);
        step.components.erase(step.components.begin());
        QCOMPARE(firstOf(compared(board(), other), Aspect::Parts), std::string("only A has R1"));
    }

    void partsThatAJobDoesNotPlaceAreComparedByTheirPins() {
        DrawnJob other = board();
        DrawnComponent& part = other.steps[0].components[0];
        part.position.x += 50'000;
        part.clockwiseDeg = 90.0;
        part.isPlaced = false;
        const Agreement agreement = compared(board(), other);
        QVERIFY(agreement.isAgreed());
        QVERIFY(find(agreement, Aspect::Parts)
                    ->note.find("where 1 part lies is not said by both jobs: its side and pins") == 0);
        part.pins[0].position.x += 50'000;
        QCOMPARE(firstOf(compared(board(), other), Aspect::Pins), std::string("R1.1 is moved by 0.0500 mm"));
        part.side = model::LayerSide::Bottom;
        QCOMPARE(firstOf(compared(board(), other), Aspect::Parts),
                 std::string("R1 is on the top in A, on the bottom in B"));
    }

    void aSideThatIsGuessedIsNotCompared() {
        DrawnJob other = board();
        DrawnComponent& part = other.steps[0].components[0];
        part.isPlaced = false;
        part.mount = model::MountType::ThroughHole;
        part.side = model::LayerSide::Bottom;
        const Agreement agreement = compared(board(), other);
        QCOMPARE(firstOf(agreement, Aspect::Parts), std::string());
        QVERIFY(find(agreement, Aspect::Parts)->note.find("the side of 1 part with pins") != std::string::npos);
        part.mount = model::MountType::Surface;
        QVERIFY(!firstOf(compared(board(), other), Aspect::Parts).empty());
        // A logo, whose drawings alone are there.
        DrawnComponent logo;
        logo.refdes = "LOGO";
        logo.position = mm(70, 40);
        DrawnJob placed = board();
        placed.steps[0].components.push_back(logo);
        logo.isPlaced = false;
        logo.side = model::LayerSide::Bottom;
        DrawnJob drawnOnly = board();
        drawnOnly.steps[0].components.push_back(logo);
        QCOMPARE(firstOf(compared(placed, drawnOnly), Aspect::Parts), std::string());
    }

    void padsWithoutANumberAreNoMissingPins() {
        DrawnJob other = board();
        DrawnComponent& part = other.steps[0].components[0];
        part.pins.push_back({"", mm(20, 25), kNoRow, kNoRow});
        for (const Agreement& agreement : {compared(board(), other), compared(other, board())}) {
            QCOMPARE(firstOf(agreement, Aspect::Pins), std::string());
            QCOMPARE(find(agreement, Aspect::Pins)->note,
                     std::string("1 pad without a number, which only one job takes for a pin, is not compared"));
        }
        part.pins.back().name = "3";
        QCOMPARE(firstOf(compared(board(), other), Aspect::Pins), std::string("only B has R1.3"));
    }

    void aRotationIsANoteWhereThePinsSayTheSame() {
        DrawnJob other = board();
        other.steps[0].components[1].clockwiseDeg = 180.0;
        const Agreement agreement = compared(board(), other);
        QVERIFY(agreement.isAgreed());
        QVERIFY(find(agreement, Aspect::Parts)->note.find("1 part states another rotation") == 0);
    }

    void slotsMayEndInChords() {
        DrawnJob milling = board();
        DrawnStep& step = milling.steps[0];
        DrawnFeature slot = line(2, mm(10, 40), mm(12, 40));
        slot.plating = model::Plating::NonPlated;
        draw(step, 3, slot);
        DrawnJob other = board();
        DrawnFeature milled = region(addRegion(other.steps[0], box({9'858'000, 39'850'000}, {12'142'000, 40'150'000})));
        milled.plating = model::Plating::NonPlated;
        draw(other.steps[0], 3, milled);
        QVERIFY(compared(milling, other).isAgreed());
        other.steps[0].regions.back() = box({9'800'000, 39'850'000}, {12'200'000, 40'150'000});
        QCOMPARE(firstOf(compared(milling, other), Aspect::Holes),
                 std::string("a hole is 2.300 x 0.300 mm in A, 2.400 x 0.300 mm in B"));
    }

    /// As in ODB++ of KiCad, whose coordinates have two decimals unless one asks for more.
    void whatOneJobRoundsToHundredthsAgrees() {
        const auto moved = [](Nm by) {
            DrawnJob job = board();
            DrawnStep& step = job.steps[0];
            step.components[0].pins[1].position.x += by;
            step.features[3][0].a.y += by;
            return job;
        };
        const DrawnJob exact = moved(4'700);
        QVERIFY(compared(exact, board()).isAgreed());
        QVERIFY(compared(board(), exact).isAgreed());
        QCOMPARE(*find(compared(exact, board()), Aspect::Holes)->farthest, 4700.0);
        // Where both are as fine, or the step is coarser than that, it was moved.
        const Aspects both = {Aspect::Holes, Aspect::Pins};
        QCOMPARE(differing(compared(exact, moved(2'300))), both);
        QCOMPARE(differing(compared(board(), moved(10'000))), both);
        QCOMPARE(differing(compared(board(), moved(7'300))), both);
    }

    void netsAreComparedByWhatTheyJoin() {
        DrawnJob other = board();
        other.steps[0].nets[0].name = "0V";
        Agreement agreement = compared(board(), other);
        QCOMPARE(differing(agreement), (Aspects{Aspect::NetNames}));
        QCOMPARE(firstOf(agreement, Aspect::NetNames), std::string("GND of A is called 0V in B"));
        other = board();
        for (DrawnFeature& feature : other.steps[0].features[1]) {
            feature.net = 0;
        }
        for (DrawnComponent& part : other.steps[0].components) {
            part.pins[1].net = 0;
        }
        agreement = compared(board(), other);
        QCOMPARE(differing(agreement), (Aspects{Aspect::Nets}));
        QCOMPARE(firstOf(agreement, Aspect::Nets), std::string("GND of B is in A: GND, SIG"));
        agreement = compared(other, board());
        QCOMPARE(firstOf(agreement, Aspect::Nets), std::string("GND of A is in B: GND, SIG"));
    }

    void aNetOfOnePinIsNone() {
        DrawnJob job = board();
        job.steps[0].nets.push_back({"unconnected-(R2-Pad2)", {}});
        job.steps[0].components[1].pins[1].net = 2;
        job.steps[0].features[1][3].net = 2;
        DrawnJob other = job;
        other.steps[0].nets.pop_back();
        other.steps[0].components[1].pins[1].net = kNoRow;
        other.steps[0].features[1][3].net = kNoRow;
        QVERIFY(compared(job, other).isAgreed());
    }

    void aNetOfOnePinIsNoneWhereItsPadIsRounded() {
        DrawnJob job = board();
        job.steps[0].nets.push_back({"UNUSED", {}});
        const auto singleNet = static_cast<std::int32_t>(job.steps[0].nets.size()) - 1;
        DrawnComponent& part = job.steps[0].components[0];
        part.pins.push_back({"3", mm(20, 25), singleNet, kNoRow});
        DrawnFeature land = pad(1, mm(20, 25), singleNet);
        land.component = 0;
        land.pin = 2;
        draw(job.steps[0], 1, land);
        DrawnJob rounded = job;
        rounded.steps[0].components[0].pins[2].position.x += 300;
        rounded.steps[0].nets.back().name = "N$3";
        QCOMPARE(firstOf(compared(rounded, job), Aspect::Nets), std::string());
        QCOMPARE(firstOf(compared(job, rounded), Aspect::Nets), std::string());
    }

    void netsOfOnePinMayNotBeExchanged() {
        const auto boardOf = [](std::int32_t first, std::int32_t second) {
            DrawnJob job = board();
            DrawnStep& step = job.steps[0];
            step.components.pop_back();
            for (auto& layer : step.features) {
                layer.clear();
            }
            step.components[0].pins[0].net = first;
            step.components[0].pins[1].net = second;
            return job;
        };
        const Agreement agreement = compared(boardOf(0, 1), boardOf(1, 0));
        QCOMPARE(differing(agreement), (Aspects{Aspect::NetNames}));
        QCOMPARE(firstOf(agreement, Aspect::NetNames), std::string("GND of A is called SIG in B"));
        DrawnJob other = boardOf(0, 1);
        other.steps[0].nets[1].name = "N$7";
        DrawnJob unconnected = boardOf(0, 1);
        unconnected.steps[0].nets[1].name = "unconnected-(R1-Pad2)";
        QVERIFY(differing(compared(unconnected, other)).empty());
    }

    /// R1.2 is in GND of B, and alone in a net of A.
    void whatAPinIsInIsNamedAlsoWhereItIsAlone() {
        DrawnJob alone = board();
        alone.steps[0].nets.push_back({"VCC", {}});
        alone.steps[0].components[1].pins[1].net = 2;
        alone.steps[0].features[1][3].net = 2;
        DrawnJob joined = alone;
        joined.steps[0].components[1].pins[1].net = 0;
        joined.steps[0].features[1][3].net = 0;
        QCOMPARE(firstOf(compared(alone, joined), Aspect::Nets), std::string("GND of B is in A: GND, VCC"));
    }

    void nothingComparedIsNoAgreement() {
        DrawnJob bare = board();
        bare.steps[0].components.clear();
        AgreementRequest request;
        request.aspects = {Aspect::Parts};
        const Agreement agreement = compared(board(), bare, request);
        QVERIFY(!agreement.isCompared() && !agreement.isAgreed());
        QVERIFY(compared(board(), board(), request).isCompared());
    }

    void whatOneJobDoesNotSayIsNotCompared() {
        DrawnJob other = board();
        other.layers.erase(other.layers.begin());
        other.steps[0].features.erase(other.steps[0].features.begin());
        other.steps[0].components.clear();
        other.steps[0].nets.clear();
        for (auto& layer : other.steps[0].features) {
            for (DrawnFeature& feature : layer) {
                feature.net = feature.component = feature.pin = kNoRow;
            }
        }
        const Agreement agreement = compared(board(), other);
        QVERIFY(agreement.isAgreed());
        const std::pair<Aspect, const char*> notes[] = {{Aspect::SolderMask, "B has no layers of this kind"},
                                                        {Aspect::Parts, "B has no parts"},
                                                        {Aspect::Pins, "B has no parts"},
                                                        {Aspect::Nets, "B has no nets"}};
        for (const auto& [aspect, note] : notes) {
            QVERIFY(find(agreement, aspect)->accord == Accord::NotCompared);
            QCOMPARE(find(agreement, aspect)->note, std::string(note));
        }
    }

    void aMissingCopperLayerDiffers() {
        DrawnJob other = board();
        addLayer(other, "INNER", LayerType::Signal);
        draw(other.steps[0], 4, pad(1, mm(5, 5)));
        const Agreement agreement = compared(board(), other);
        QCOMPARE(differing(agreement), (Aspects{Aspect::Copper, Aspect::Holes}));  // which pass one layer more
        const auto isInner = [](const Comparison& c) { return c.layers[1] == "INNER"; };
        const auto inner = std::ranges::find_if(agreement.comparisons, isInner);
        QCOMPARE(inner->differences[0].text, std::string("A has no such layer"));
    }

    void anotherOriginIsFound() {
        DrawnJob other = board();
        moveAll(other, mm(-7, 11));
        const Agreement agreement = compared(board(), other);
        QCOMPARE(agreement.shift, mm(7, -11));
        QVERIFY(agreement.isAgreed());
        other.steps[0].profile = box(mm(-7, 11), mm(90, 61));  // another outline alone is no other origin
        QCOMPARE(differing(compared(board(), other)), (Aspects{Aspect::Outline}));
    }

    void copiesCountWhereTheyLie() {
        const auto panel = [](Point second, bool isFlipped) {
            DrawnJob job = board();
            DrawnStep outer;
            outer.name = "panel";
            outer.profile = box(mm(0, 0), mm(300, 100));
            outer.copies.push_back({1, {mm(0, 0), 0.0, false}, false, 1});
            outer.copies.push_back({1, {second, 0.0, isFlipped}, isFlipped, 2});
            job.steps.insert(job.steps.begin(), outer);
            return job;
        };
        QVERIFY(compared(panel(mm(120, 0), false), panel(mm(120, 0), false)).isAgreed());
        const Agreement moved = compared(panel(mm(120, 0), false), panel(mm(121, 0), false));
        QCOMPARE(find(moved, Aspect::Holes)->counts[0], std::size_t{4});
        QCOMPARE(find(moved, Aspect::Holes)->differing, std::size_t{4});
        const Agreement flipped = compared(panel(mm(240, 0), true), panel(mm(240, 0), true));
        QVERIFY(flipped.isAgreed());
        const auto isBottom = [](const Comparison& c) { return c.layers[0] == "BOTTOM"; };
        QVERIFY(std::ranges::any_of(flipped.comparisons, isBottom));  // what the flipped copy has on its top
    }

    void layersArePairedByOrderAndSide() {
        DrawnJob a = board();
        DrawnJob b = board();
        for (DrawnLayer& layer : b.layers) {
            layer.name = "L" + layer.name;
        }
        draw(a.steps[0], 2, pad(1, mm(5, 5)));
        const auto ours = assembled(a);
        const auto theirs = assembled(b);
        const std::vector<model::LayerPair> pairs = model::pairLayers(*ours, *theirs);
        QCOMPARE(pairs.size(), std::size_t{3});
        QCOMPARE(theirs->layer(pairs[0].b).name, std::string("LTOP"));
        QCOMPARE(theirs->layer(pairs[1].b).name, std::string("LBOTTOM"));
        QCOMPARE(theirs->layer(pairs[2].b).name, std::string("LMASK TOP"));
    }

    void namesOfAspectsAreKnown() {
        for (std::size_t aspect = 0; aspect < model::kAspectCount; ++aspect) {
            QCOMPARE(*model::aspectNamed(model::toString(static_cast<Aspect>(aspect))), static_cast<Aspect>(aspect));
        }
        QVERIFY(!model::aspectNamed("colour"));
    }

    void cancellingEndsIt() {
        base::Progress progress;
        progress.cancel();
        const auto document = assembled(board());
        QCOMPARE(compareBoards(*document, *document, {}, progress).error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(AgreementTest)
#include "agreement_test.moc"
