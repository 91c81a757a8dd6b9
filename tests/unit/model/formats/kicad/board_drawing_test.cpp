#include "model/formats/kicad/board_drawing.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

#include "model/geometry/discretise.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"
#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

double mm2(const ShapeSketch& sketch) {
    return static_cast<double>(twiceArea(polygonsOf(sketch, {Discretisation::kMinChordNm, false}))) / 2e12;
}

/// The first one that is drawn on a layer.
const ShapeSketch& regionOf(const DrawnJob& job, std::string_view layer) {
    const auto& features = on(job, layer);
    const auto found = std::ranges::find(features, DrawnKind::Region, &DrawnFeature::kind);
    if (found == features.end()) {
        qFatal("there is no region");
    }
    return job.steps[0].regions[static_cast<std::size_t>(found->region)];
}

/// A board with a layer for fabrication.
DrawnJob fabBoard(const std::string& items) {
    return drawn("(kicad_pcb (version 20241229) (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal) (49 \"F.Fab\" user)) " +
                 items + ")");
}

}  // namespace

class BoardDrawingTest : public QObject {
    Q_OBJECT

private slots:
    void viasThatAreWronglyCalledMicroviasAreReported() {
        const auto said = [](const char* layers) {
            const DrawnJob job =
                boardWith("(via micro (at 5 5) (size 0.5) (drill 0.2) (layers " + std::string(layers) + ") (net 1))");
            return messages(job.diagnostics, "A via is called a microvia, but goes through the whole board");
        };
        QCOMPARE(said("\"F.Cu\" \"B.Cu\""), 1U);
        QCOMPARE(said("\"F.Cu\" \"In1.Cu\""), 0U);
    }

    void layersHaveTheNamesOfUsersInPhysicalOrder() {
        const DrawnJob job = drawn(fileText("small.kicad_pcb"));
        std::vector<std::string> names;
        for (const formats::DrawnLayer& layer : job.layers) {
            names.push_back(layer.name);
        }
        const std::vector<std::string> expected = {"F.Silkscreen", "F.Paste",          "F.Mask",  "Top copper",
                                                   "dielectric 1", "dielectric 1 (2)", "In1.Cu",  "dielectric 2",
                                                   "B.Cu",         "B.Mask",           "B.Paste", "B.SilkS"};
        QVERIFY(std::equal(expected.begin(), expected.end(), names.begin()));
        QCOMPARE(job.layers[4].facts.thicknessNm, std::optional(2e5));
        QCOMPARE(job.layers[4].facts.material.dielectricConstant, std::optional(4.2));
        QCOMPARE(job.layers[5].facts.thicknessNm, std::optional(1e5));
        QCOMPARE(job.layers[5].facts.material.name, std::string("1080"));
        QCOMPARE(job.layers[5].facts.material.type, std::string("PREPREG"));
        QCOMPARE(job.layers[6].type, LayerType::PowerGround);
        QCOMPARE(job.boardNm, std::optional(1.58e6));
    }

    /// Without a stackup the masks are as thick as KiCad has them; they are in the thickness all the same.
    void theThicknessOfTheBoardHasItsMasks() {
        QCOMPARE(boardWith("(general (thickness 1.6))").boardNm, std::optional(1.6e6 - 2.0 * 10'000));
    }

    void padsLieWhereTheirFootprintPutsThem() {
        const DrawnJob job = drawn(fileText("small.kicad_pcb"));
        const auto& copper = on(job, "Top copper");
        QCOMPARE(copper[0].a, (Point{10 * kMm, -11 * kMm}));
        QCOMPARE(copper[0].clockwiseDeg, -90.0);
        QCOMPARE(netOf(job, copper[0]), std::string("GND"));
        QCOMPARE(copper[1].a, (Point{10 * kMm, -9 * kMm}));
        QCOMPARE(netOf(job, copper[1]), std::string("A{slash}B"));
        QVERIFY(std::abs(mm2(shapeOf(job, copper[1]).region) - (0.16 + 0.1 - 0.5 * 0.2 * 0.04)) < 1e-4);
        QCOMPARE(shapeOf(job, on(job, "F.Mask")[0]).width, 1'100'000);
        QCOMPARE(shapeOf(job, on(job, "F.Paste")[0]).width, 1'000'000);
    }

    void theHoleIsWhereThePadIsAndItsCopperIsMoved() {
        const DrawnJob job = drawn(fileText("small.kicad_pcb"));
        const auto& holes = on(job, "drill_plated_Top copper-B.Cu");
        QCOMPARE(holes[0].kind, DrawnKind::Line);
        QCOMPARE((Point{(holes[0].a.x + holes[0].b.x) / 2, holes[0].a.y}), (Point{20 * kMm, -9 * kMm}));
        QCOMPARE(std::abs(holes[0].a.x - holes[0].b.x), 600'000);
        QCOMPARE(holes[0].plating, Plating::Plated);
        QCOMPARE(on(job, "B.Cu")[0].a, (Point{19'700'000, -9 * kMm}));
        QCOMPARE(on(job, "drill_non-plated_Top copper-B.Cu").size(), std::size_t{1});
        QCOMPARE(on(job, "B.Mask").size(), std::size_t{2});
        QCOMPARE(on(job, "B.Cu").size(), std::size_t{3});  // pad, via, zone: none around the bare hole
    }

    void footprintsLieWhereTheirTransformSays() {
        const auto job = [](const std::string& place) {
            return boardWith("(footprint \"T:x\" (layer \"F.Cu\") " + place +
                             " (pad \"1\" smd rect (at 1 0 90) (size 1 0.5) (layers \"F.Cu\") (net 1)))");
        };
        const DrawnJob old = job("(at 5 6 90)");
        const DrawnJob later = job("(transform (translate 5 6) (rotate 90) (scale 1 1))");
        QCOMPARE(on(later, "F.Cu")[0].a, (Point{5 * kMm, -5 * kMm}));
        QCOMPARE(on(later, "F.Cu")[0].a, on(old, "F.Cu")[0].a);
        QCOMPARE(later.steps[0].components[0].position, old.steps[0].components[0].position);
        QCOMPARE(later.steps[0].components[0].clockwiseDeg, old.steps[0].components[0].clockwiseDeg);
        QCOMPARE(messages(later.diagnostics, "transform"), 0U);
        QCOMPARE(messages(later.diagnostics, "is scaled"), 0U);
        QCOMPARE(messages(job("(transform (translate 5 6) (scale 2 1))").diagnostics, "is scaled"), 1U);
    }

    void componentsOfOneDesignatorAreTold() {
        const auto footprint = [](const char* name, const char* pad) {
            return "(footprint \"T:x\" (layer \"F.Cu\") (at 5 5) (property \"Reference\" \"" + std::string(name) +
                   "\")" + pad + ")\n";
        };
        constexpr const char* kPad = "(pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\"))";
        const auto told = [](const std::string& items) {
            return messages(boardWith(items).diagnostics, "components have one designator");
        };
        QCOMPARE(told(footprint("R1", kPad) + footprint("R1", kPad) + footprint("R2", kPad)), 1U);
        QCOMPARE(told(footprint("R1", kPad) + footprint("r1", kPad)), 0U);
        QCOMPARE(told(footprint("REF**", kPad) + footprint("REF**", kPad)), 0U);
        QCOMPARE(told(footprint("LOGO", "") + footprint("LOGO", "")), 0U);
    }

    void componentsAndPackagesAgree() {
        const DrawnJob job = drawn(fileText("small.kicad_pcb"));
        const auto& components = job.steps[0].components;
        QCOMPARE(components.size(), std::size_t{2});
        QCOMPARE(components[0].refdes, std::string("R1"));
        QCOMPARE(components[0].part, std::string("10k"));
        QVERIFY(!components[0].isPopulated);
        QCOMPARE(components[0].mount, MountType::Surface);
        QCOMPARE(components[1].side, LayerSide::Bottom);
        for (const formats::DrawnComponent& component : components) {
            const Placement placement{component.position, component.clockwiseDeg, *component.isMirrored};
            const auto& package = job.steps[0].packages[static_cast<std::size_t>(component.package)];
            QCOMPARE(component.pins.size(), package.pins.size());
            for (std::size_t i = 0; i < component.pins.size(); ++i) {
                QCOMPARE(placement.apply(package.pins[i].position), component.pins[i].position);
            }
            QVERIFY(!package.outline.isEmpty());
        }
        QCOMPARE(boxOf(job.steps[0].packages[0].outline).width(), std::int64_t{3 * kMm});
    }

    void bodiesDoNotDependOnTheOrderOfLines() {
        // A connector with a plug behind it, one line for both.
        std::vector<std::string> lines;
        for (const char* ends :
             {"(start -3 4.575) (end 3 4.575)", "(start 3 4.575) (end 3 2.575)", "(start -3 2.575) (end -3 4.575)",
              "(start -3 2.575) (end 3 2.575)", "(start -3 -1.675) (end -3 2.575)", "(start -3 -1.675) (end 3 -1.675)",
              "(start 3 -1.675) (end 3 2.575)"}) {
            lines.push_back("(fp_line " + std::string(ends) + " (layer \"F.Fab\"))");
        }
        const auto bodyOf = [&] {
            std::string items = "(footprint \"T:x\" (layer \"F.Cu\") (at 5 5) (property \"Reference\" \"J1\")";
            for (const std::string& line : lines) {
                items += line;
            }
            return boxOf(fabBoard(items + ")").steps[0].packages[0].outline);
        };
        const Box body = bodyOf();
        QCOMPARE(body.width(), 6 * std::int64_t{kMm});
        QCOMPARE(body.height(), 25 * std::int64_t{kMm} / 4);
        std::ranges::reverse(lines);
        QCOMPARE(bodyOf(), body);
    }

    void viasReachFromLayerToLayer() {
        const DrawnJob job = drawn(fileText("small.kicad_pcb"));
        QCOMPARE(on(job, "drill_plated_Top copper-In1.Cu").size(), std::size_t{1});
        QCOMPARE(on(job, "drill_plated_Top copper-In1.Cu")[0].plating, Plating::Via);
        QCOMPARE(on(job, "drill_plated_Top copper-B.Cu").size(), std::size_t{2});
        // The through via keeps no pad on the inner layer, where nothing ends at it; the header and the blind one do.
        QCOMPARE(on(job, "In1.Cu").size(), std::size_t{3});
        QCOMPARE(on(job, "F.Mask").size(), std::size_t{5});  // the blind via is not tented
    }

    void unusedLayersKeepWhatTracksReach() {
        const std::string via =
            "(via (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") (remove_unused_layers yes) "
            "(keep_end_layers yes) (net 1))";
        QCOMPARE(on(boardWith(via), "In1.Cu").size(), std::size_t{0});
        QCOMPARE(on(boardWith(via), "F.Cu").size(), std::size_t{1});
        const std::string track = "(segment (start 1.1 1) (end 5 1) (width 0.2) (layer \"In1.Cu\") (net 1))";
        QCOMPARE(on(boardWith(via + track), "In1.Cu").size(), std::size_t{2});
        const std::string other = "(segment (start 1.1 1) (end 5 1) (width 0.2) (layer \"In1.Cu\") (net 0))";
        QCOMPARE(on(boardWith(via + other), "In1.Cu").size(), std::size_t{1});
        const std::string ends =
            "(via (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") (start_end_only yes) (net 1))";
        QCOMPARE(on(boardWith(ends + track), "In1.Cu").size(), std::size_t{1});  // the track alone
        QCOMPARE(on(boardWith(ends), "B.Cu").size(), std::size_t{1});
    }

    void unusedLayersKeepWhatViasAndPadsTouch() {
        const auto via = [](double x, const char* net, const char* unused = "(remove_unused_layers yes) ") {
            return "(via (at " + std::to_string(x) + " 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") " + unused +
                   "(keep_end_layers yes) (net " + net + "))";
        };
        // Two that touch with their pads on the outer layers keep them on the inner one.
        QCOMPARE(on(boardWith(via(1, "1") + via(1.59, "1")), "In1.Cu").size(), std::size_t{2});
        QCOMPARE(on(boardWith(via(1, "1") + via(1.61, "1")), "In1.Cu").size(), std::size_t{0});
        QCOMPARE(on(boardWith(via(1, "1") + via(1.59, "0")), "In1.Cu").size(), std::size_t{0});
        QCOMPARE(on(boardWith(via(1, "1") + via(1.59, "1", "")), "In1.Cu").size(), std::size_t{2});
        // A land that it lies in keeps its pad on that layer alone: 45 degrees round, one corner reaches it.
        const auto land = [](const char* degrees) {
            return "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" smd rect (at 3 3 " + std::string(degrees) +
                   ") (size 5 0.2) (layers \"F.Cu\") (net 1)))";
        };
        const std::string bare =
            "(via (at 1.5 4.5) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") "
            "(remove_unused_layers yes) (keep_end_layers no) (net 1))";
        QCOMPARE(on(boardWith(bare + land("45")), "F.Cu").size(), std::size_t{2});
        QCOMPARE(on(boardWith(bare + land("45")), "B.Cu").size(), std::size_t{0});
        QCOMPARE(on(boardWith(bare + land("135")), "F.Cu").size(), std::size_t{1});
    }

    void outerLayersAreKeptOnlyWhereTheFileSaysSo() {
        const auto pad = [](const std::string& ends) {
            return "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" thru_hole circle (at 1 1) (size 2 2) (drill "
                   "1) "
                   "(layers \"*.Cu\") (remove_unused_layers yes) " +
                   ends + " (net 1)))";
        };
        const std::string track = "(segment (start 1.1 1) (end 5 1) (width 0.2) (layer \"B.Cu\") (net 1))";
        QCOMPARE(on(boardWith(pad("")), "F.Cu").size(), std::size_t{0});
        QCOMPARE(on(boardWith(pad("(keep_end_layers yes)")), "F.Cu").size(), std::size_t{1});
        QCOMPARE(on(boardWith(pad("(keep_end_layers)")), "F.Cu").size(), std::size_t{1});
        const DrawnJob job = boardWith(pad("(keep_end_layers no)") + track);
        QCOMPARE(on(job, "F.Cu").size(), std::size_t{0});
        QCOMPARE(on(job, "B.Cu").size(), std::size_t{2});
        const DrawnJob via = boardWith(
            "(via (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") (remove_unused_layers) (free) (net 1))" +
            track);
        QCOMPARE(on(via, "F.Cu").size(), std::size_t{0});
        QCOMPARE(on(via, "B.Cu").size(), std::size_t{2});
    }

    void onlyViasWithATypeEndOnTheLayersTheyName() {
        const std::string via = " (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"In1.Cu\") (net 1))";
        const DrawnJob through = boardWith("(via" + via);
        QCOMPARE(on(through, "B.Cu").size(), std::size_t{1});
        QCOMPARE(on(through, "drill_plated_F.Cu-B.Cu").size(), std::size_t{1});
        QCOMPARE(messages(through.diagnostics, "not called blind"), 1U);
        for (const char* type : {"blind", "buried", "micro"}) {
            const DrawnJob partial = boardWith("(via " + std::string(type) + via);
            QCOMPARE(on(partial, "B.Cu").size(), std::size_t{0});
            QCOMPARE(messages(partial.diagnostics, "not called blind"), 0U);
        }
    }

    void viasAreTentedUnlessSaidOtherwise() {
        const std::string via = "(via (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") (net 1) ";
        QCOMPARE(on(boardWith(via + ")"), "F.Mask").size(), std::size_t{0});
        QCOMPARE(on(boardWith(via + ")", "(tenting back)"), "F.Mask").size(), std::size_t{1});
        QCOMPARE(on(boardWith(via + ")", "(tenting (front no) (back yes))"), "F.Mask").size(), std::size_t{1});
        QCOMPARE(on(boardWith(via + "(tenting back))"), "F.Mask").size(), std::size_t{1});
        QCOMPARE(on(boardWith(via + "(tenting (front yes) (back no)))"), "B.Mask").size(), std::size_t{1});
        const DrawnJob old = boardWith(via + ")", "(pcbplotparams (viasonmask true))", "20221018");
        QCOMPARE(on(old, "B.Mask").size(), std::size_t{1});
    }

    void openingsOfViasAreAsLargeAsTheirSide() {
        const DrawnJob job = boardWith(
            "(via (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") (net 1) (tenting none) (padstack (mode "
            "front_inner_back) (layer \"Inner\" (size 0.5)) (layer \"B.Cu\" (size 1.2))))",
            "(pad_to_mask_clearance 0.1) (tenting none)");
        QCOMPARE(shapeOf(job, on(job, "F.Mask")[0]).width, 800'000);
        QCOMPARE(shapeOf(job, on(job, "B.Mask")[0]).width, 1'400'000);
    }

    void whatProtectsHolesOfViasIsReported() {
        const std::string via =
            "(via (at 1 1) (size 0.6) (drill 0.3) (layers \"F.Cu\" \"B.Cu\") (net 1) (capping yes) (filling no) "
            "(covering "
            "(front yes) (back no)) (plugging (front no) (back no)))";
        const DrawnJob job = boardWith(via + via, "(filling yes) (capping none)");
        QCOMPARE(messages(job.diagnostics, "vias as 'capping'"), 2U);
        QCOMPARE(messages(job.diagnostics, "vias as 'covering'"), 2U);
        QCOMPARE(messages(job.diagnostics, "vias as 'filling'"), 1U);
        QCOMPARE(messages(job.diagnostics, "vias as 'plugging'"), 0U);
    }

    void openingsOfGraphicsHaveTheMarginOfTheBoard() {
        const std::string shape = "(start 0 0) (end 2 1) (layers \"F.Cu\" \"F.Mask\") (stroke (width ";
        const DrawnJob lines =
            boardWith("(gr_line " + shape + "0.3))) (gr_line " + shape + "0.3)) (solder_mask_margin 0))",
                      "(pad_to_mask_clearance 0.1)");
        QCOMPARE(shapeOf(lines, on(lines, "F.Cu")[0]).width, 300'000);
        QCOMPARE(shapeOf(lines, on(lines, "F.Mask")[0]).width, 500'000);
        QCOMPARE(shapeOf(lines, on(lines, "F.Mask")[1]).width, 300'000);
        const DrawnJob onMask = boardWith("(gr_line (start 0 0) (end 2 1) (layer \"F.Mask\") (stroke (width 0.3)))",
                                          "(pad_to_mask_clearance 0.1)");
        QCOMPARE(shapeOf(onMask, on(onMask, "F.Mask")[0]).width, 300'000);
    }

    void negativeMarginsMakeOpeningsSmaller() {
        const std::string shape = "(start 0 0) (end 2 1) (layers \"F.Cu\" \"F.Mask\") (stroke (width ";
        const DrawnJob filled = boardWith("(gr_rect " + shape + "0)) (fill yes))", "(pad_to_mask_clearance -0.1)");
        QCOMPARE(on(filled, "F.Mask").size(), std::size_t{1});
        QVERIFY(std::abs(mm2(regionOf(filled, "F.Mask")) - 1.8 * 0.8) < 1e-6);
        const DrawnJob line = boardWith("(gr_line " + shape + "0.1)))", "(pad_to_mask_clearance -0.1)");
        QCOMPARE(on(line, "F.Mask").size(), std::size_t{0});
    }

    void hatchedShapesAreNotSolid() {
        const std::string shape = "(gr_rect (start 0 0) (end 2 1) (stroke (width 0.1)) (fill cross_hatch) ";
        const DrawnJob copper = boardWith(shape + "(layer \"F.Cu\"))");
        QCOMPARE(on(copper, "F.Cu").size(), std::size_t{4});
        QVERIFY(copper.steps[0].regions.empty());
        // KiCad opens all of the mask over it.
        const DrawnJob open = boardWith(shape + "(layers \"F.Cu\" \"F.Mask\"))");
        QCOMPARE(on(open, "F.Mask").size(), std::size_t{5});
        QVERIFY(std::abs(mm2(regionOf(open, "F.Mask")) - 2.0) < 1e-9);
    }

    void padStacksDifferByLayer() {
        const DrawnJob job = boardWith(
            "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" thru_hole circle (at 0 0) (size 2 2) (drill 1) "
            "(layers \"*.Cu\") (padstack (mode front_inner_back) (layer \"Inner\" (shape rect) (size 1.5 1.4)) "
            "(layer \"B.Cu\" (shape circle) (size 1.8 1.8)))))");
        QCOMPARE(shapeOf(job, on(job, "F.Cu")[0]).width, 2 * kMm);
        QCOMPARE(shapeOf(job, on(job, "In1.Cu")[0]).height, 1'400'000);
        QCOMPARE(shapeOf(job, on(job, "B.Cu")[0]).width, 1'800'000);
    }

    void pasteShrinksByMarginAndRatio() {
        const DrawnJob job = boardWith(
            "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (solder_paste_margin_ratio -0.15) (pad \"1\" smd rect (at 0 0) "
            "(size 0.8 0.815) (layers \"F.Cu\" \"F.Paste\")) (pad \"\" smd rect (at 5 0) (size 1 1) (layers "
            "\"F.Paste\")))");
        QCOMPARE(shapeOf(job, on(job, "F.Paste")[0]).width, 560'000);
        QCOMPARE(shapeOf(job, on(job, "F.Paste")[0]).height, 570'500);
        QCOMPARE(shapeOf(job, on(job, "F.Paste")[1]).width, 1'000'000);
    }

    void oldFillsAreGrownAndNewOnesAreNot() {
        const std::string zone = "(zone (net 1) (net_name \"GND\") (layer \"F.Cu\") (min_thickness 0.2) ";
        const std::string fill = "(filled_polygon (layer \"F.Cu\") (pts (xy 0 0) (xy 4 0) (xy 4 4) (xy 0 4))))";
        const auto areaOf = [](const DrawnJob& job) {
            return mm2(job.steps[0].regions[static_cast<std::size_t>(on(job, "F.Cu")[0].region)]);
        };
        const double grown = 16 + 1.6 + 0.0314159;
        QVERIFY(std::abs(areaOf(boardWith(zone + fill, "", "20211014")) - grown) < 1e-3);
        QVERIFY(std::abs(areaOf(boardWith(zone + "(filled_areas_thickness no)" + fill, "", "20211014")) - 16.0) < 1e-9);
        QVERIFY(std::abs(areaOf(boardWith(zone + fill, "", "20260206")) - 16.0) < 1e-9);
    }

    void zonesWithoutFillAreReported() {
        const DrawnJob job = boardWith("(zone (net 1) (layer \"F.Cu\") (polygon (pts (xy 0 0) (xy 4 0) (xy 4 4))))");
        QCOMPARE(on(job, "F.Cu").size(), std::size_t{0});
        QCOMPARE(messages(job.diagnostics, "not filled"), 1U);
    }

    /// Unless no zone has copper: then the fills are not in the file.
    void emptyFillsAreNoMissingCopper() {
        const std::string zone = "(zone (net 1) (layer \"F.Cu\") (fill yes) ";
        const std::string filled = zone + "(filled_polygon (layer \"F.Cu\") (pts (xy 0 0) (xy 4 0) (xy 4 4))))";
        const DrawnJob one = boardWith(zone + ")" + filled);
        QCOMPARE(messages(one.diagnostics, "not filled"), 0U);
        QCOMPARE(messages(one.diagnostics, "zone is filled with nothing"), 1U);
        QCOMPARE(messages(boardWith(zone + ")").diagnostics, "not filled"), 1U);
    }

    void netsHaveNamesOrNumbers() {
        const DrawnJob job = boardWith(
            "(segment (start 0 0) (end 1 0) (width 0.2) (layer \"F.Cu\") (net \"NEW\"))"
            "(segment (start 0 0) (end 1 0) (width 0.2) (layer \"F.Cu\") (net 1))"
            "(segment (start 0 0) (end 1 0) (width 0.2) (layer \"F.Cu\") (net 7))");
        QCOMPARE(netOf(job, on(job, "F.Cu")[0]), std::string("NEW"));
        QCOMPARE(netOf(job, on(job, "F.Cu")[1]), std::string("GND"));
        QCOMPARE(netOf(job, on(job, "F.Cu")[2]), std::string());
        QCOMPARE(messages(job.diagnostics, "number of a net"), 1U);
    }

    void netsHaveTheirClassAsAProperty() {
        kicad::Project project;
        project.classPatterns.emplace_back("G*", "Power");
        const DrawnJob job = drawn(fileText("small.kicad_pcb"), project);
        QCOMPARE(job.steps[0].nets[0].properties, (formats::Words{{"net_class", "Power"}}));
        QCOMPARE(job.steps[0].nets[1].properties, (formats::Words{{"net_class", "Default"}}));
    }

    void groupsOfPadsArePropertiesOfTheComponent_data() {
        QTest::addColumn<QByteArray>("declared");
        QTest::addColumn<QByteArray>("version");
        QTest::addColumn<QStringList>("properties");
        const auto row = [](const char* name, const char* declared, const char* version, const QStringList& expected) {
            QTest::newRow(name) << QByteArray(declared) << QByteArray(version) << expected;
        };
        row("ties", "(net_tie_pad_groups \"1, 2\" \"3,4\")", "20241229",
            {"net_tie_pad_groups=1, 2", "net_tie_pad_groups=3,4"});
        row("a tie by keywords", "(tags \"net tie solder\")", "20211014",
            {"net_tie_pad_groups=1, 2", "tags=net tie solder"});
        row("keywords of new boards", "(tags \"net tie solder\")", "20241229", {"tags=net tie solder"});
        row("jumpers", "(jumper_pad_groups (\"1\" \"2\") (\"3\" \"4\"))", "20260206",
            {"jumper_pad_groups=1, 2", "jumper_pad_groups=3, 4"});
        row("jumpers by number", "(duplicate_pad_numbers_are_jumpers yes)", "20260206",
            {"duplicate_pad_numbers_are_jumpers=yes"});
        row("no jumpers by number", "(duplicate_pad_numbers_are_jumpers no)", "20260206", {});
    }
    void groupsOfPadsArePropertiesOfTheComponent() {
        QFETCH(QByteArray, declared);
        QFETCH(QByteArray, version);
        QFETCH(QStringList, properties);
        const DrawnJob job = boardWith("(footprint \"x\" (layer \"F.Cu\") (at 0 0) " + declared.toStdString() +
                                           " (pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\"))"
                                           " (pad \"2\" smd rect (at 2 0) (size 1 1) (layers \"F.Cu\")))",
                                       "", version.toStdString());
        QStringList found;
        for (const auto& [name, value] : job.steps[0].components[0].properties) {
            found << QString::fromStdString(name + '=' + value);
        }
        QCOMPARE(found, properties);
    }

    void theOutlineHasItsCutOuts() {
        const DrawnJob job = drawn(fileText("small.kicad_pcb"));
        QVERIFY(std::abs(mm2(job.steps[0].profile) - (600.0 - 3.14159265)) < 5e-3);
    }

    void anOutlineThatIsDrawnTwiceIsOne() {
        const auto side = [](const char* ends) { return "(gr_line " + std::string(ends) + " (layer \"Edge.Cuts\"))"; };
        const std::string sides = side("(start 0 0) (end 30 0)") + side("(start 30 0) (end 30 20)") +
                                  side("(start 30 20) (end 0 20)") + side("(start 0 0) (end 0 20)");
        for (const std::string& outline :
             {sides + sides, side("(start 0 0) (end 30 0)") + side("(start 30 0) (end 0 0)") + sides}) {
            const DrawnJob job = boardWith(outline);
            QVERIFY(std::abs(mm2(job.steps[0].profile) - 600.0) < 1e-9);
            QCOMPARE(messages(job.diagnostics, "ines on Edge.Cuts that are drawn again on others count once"), 1U);
            QCOMPARE(messages(job.diagnostics, "outline is open"), 0U);
            QCOMPARE(messages(job.diagnostics, "close no outline"), 0U);
        }
    }

    /// What closes beside it are holes: they hold no pads.
    void aGapInTheOutlineIsClosedAndSaid() {
        const std::string pad =
            "(footprint \"x\" (layer \"F.Cu\") (at 10 10) (pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\")))";
        const auto side = [](const char* ends) { return "(gr_line " + std::string(ends) + " (layer \"Edge.Cuts\"))"; };
        const DrawnJob job = boardWith(pad + side("(start 0 0) (end 30 0)") + side("(start 30 0.2) (end 30 20)") +
                                       side("(start 30 20) (end 0 20)") + side("(start 0 0) (end 0 20)") +
                                       "(gr_circle (center 4 4) (end 5 4) (layer \"Edge.Cuts\"))");
        QVERIFY(std::abs(mm2(job.steps[0].profile) - (600.0 - 3.14159265)) < 0.01);
        QCOMPARE(messages(job.diagnostics,
                          "The board's outline is open by 0.20 mm at (30.00, -0.10) mm; a straight "
                          "line closes it"),
                 1U);
        QCOMPARE(messages(job.diagnostics, "lines on Edge.Cuts that close no outline"), 0U);
    }

    void textsAreDrawnWithTheirVariables() {
        const DrawnJob job = drawn(fileText("small.kicad_pcb"));
        std::vector<std::string> texts;
        for (const formats::DrawnGroup& group : job.steps[0].groups) {
            texts.push_back(group.properties[0].second);
            QVERIFY(!group.features.empty());
        }
        std::ranges::sort(texts);
        QCOMPARE(texts, (std::vector<std::string>{"30", "Conn", "J1", "R1", "Small board B", "cached"}));
    }

    void textsAreDrawnWithoutTheirEscapes() {
        const DrawnJob job = boardWith(
            "(gr_text \"check {dblquote}front{dblquote} ~{slash}\" (at 1 1) (layer \"F.Cu\") (effects (font (size 1 "
            "1))))");
        QCOMPARE(job.steps[0].groups.size(), std::size_t{1});
        QCOMPARE(job.steps[0].groups[0].properties[0].second, std::string("check \"front\" ~{slash}"));
    }

    void oldBoardsAreRead() {
        const DrawnJob job = drawn(fileText("old.kicad_pcb"));
        QCOMPARE(job.info.version, std::string("KiCad 4 (4)"));
        QCOMPARE(job.info.generator, std::string("pcbnew 4.0.7"));
        QCOMPARE(on(job, "Top").size(), std::size_t{3});
        QCOMPARE(shapeOf(job, on(job, "drill_plated_Top-Bottom")[1]).width, 400'000);
        QCOMPARE(on(job, "F.Mask").size(), std::size_t{2});
        QVERIFY(std::abs(mm2(job.steps[0].profile) - 100.0) < 1e-9);
        QCOMPARE(job.steps[0].components[0].refdes, std::string("U1"));
        const auto& region = job.steps[0].regions[static_cast<std::size_t>(on(job, "Bottom").back().region)];
        QVERIFY(std::abs(mm2(region) - (16 + 1.6 + 0.0314159)) < 1e-3);
        // Centre, start and a quarter turn clockwise.
        const DrawnFeature& arc = on(job, "F.SilkS")[static_cast<std::size_t>(on(job, "F.SilkS").size() - 1)];
        QCOMPARE(arc.kind, DrawnKind::Arc);
        QVERIFY(arc.isClockwise);
        QCOMPARE(arc.a, (Point{6 * kMm, -5 * kMm}));
        QCOMPARE(arc.b, (Point{5 * kMm, -6 * kMm}));
    }

    void whatIsOutOfRangeIsReported() {
        const DrawnJob job = boardWith(
            "(segment (start 0 0) (end 1e6 0) (width 0.2) (layer \"F.Cu\") (net 1))"
            "(footprint \"x\" (layer \"F.Cu\") (at 1e5 0) (pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\")))"
            "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (pad \"1\" smd rect (at 0 0) (size 1e5 1) (layers \"F.Cu\")))");
        QCOMPARE(on(job, "F.Cu").size(), std::size_t{0});
        QVERIFY(messages(job.diagnostics, "coordinate range") >= 3U);
    }

    void factsOfTheStackupThatAreNotReadAreReported() {
        const DrawnJob job =
            boardWith("", "(stackup (copper_finish \"ENIG\") (castellated_pads yes) (edge_plating no))");
        QCOMPARE(messages(job.diagnostics, "is not read"), 2U);
        QCOMPARE(messages(boardWith("", "(stackup (copper_finish \"None\"))").diagnostics, "is not read"), 0U);
    }

    void variantsAreReportedAsNotRead() {
        const DrawnJob job = boardWith(
            "(variants (variant (name \"A\") (description \"cheap\")))\n"
            "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (variant (name \"A\") (dnp yes)))");
        QCOMPARE(messages(job.diagnostics, "what is shown and populated is the base"), 2U);
        QVERIFY(job.steps[0].components[0].isPopulated);
        const auto& entries = job.diagnostics.entries();
        const auto found = std::ranges::find_if(entries, [](const auto& entry) {
            return entry.text.find("what is shown and populated is the base") != std::string::npos;
        });
        QCOMPARE(found->line, 2U);
        QCOMPARE(messages(boardWith("(variants)").diagnostics, "what is shown and populated is the base"), 0U);
    }

    void aBoardWithoutCopperIsNone() {
        base::Progress progress;
        const auto job = kicad::drawBoard("(kicad_pcb (version 4))", "x", {}, progress);
        QVERIFY(!job);
        QCOMPARE(job.error().code, base::ErrorCode::BadInput);
        progress.cancel();
        const auto cancelled = kicad::drawBoard(fileText("small.kicad_pcb"), "x", {}, progress);
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(BoardDrawingTest)
#include "board_drawing_test.moc"
