// Rigid-flex boards: zones, where layers exist, and what of the laminate that leaves.
#include "model/formats/odb/stackup/zones.h"

#include "model/figures/element_polygons.h"
#include "model/formats/odb/rigid_flex.h"
#include "model/geometry/discretise.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using model::Diagnostics;
using model::Document;
using model::Layer;
using model::LayerType;
using model::Nm;

namespace {

const std::string kSquare = "S P 0\nOB 0 0 I\nOS 0 10\nOS 10 10\nOS 10 0\nOS 0 0\nOE\nSE\n";

double areaOf(const Document& document, model::ShapeId shape) {
    return static_cast<double>(model::twiceArea(model::discretise(document.shapes, shape, {}))) / 2e12;
}

const Layer& layerOf(const Document& document, const std::string& name) {
    return document.layer(document.findLayer(name));
}

/// Square millimetres where a layer exists; 0: all over the board.
double areaOf(const Document& document, const std::string& name) {
    const Layer& layer = layerOf(document, name);
    return layer.profile.isValid() ? areaOf(document, layer.profile) : 0.0;
}

model::odb::ZoneFile parse(const std::string& text, Diagnostics& diagnostics) {
    return model::odb::parseZones(text, "zones", model::odb::Unit::Millimetre, diagnostics);
}

/// Bodies of a document from the top, as (square millimetres, thickness).
std::vector<std::pair<double, Nm>> bodiesOf(const Document& document) {
    std::vector<std::pair<double, Nm>> found;
    for (const Layer& layer : document.layers) {
        if (layer.type == LayerType::Body) {
            const model::ElementId body{layer.elements.first};
            const double area =
                layer.elements.count == 0
                    ? 0.0
                    : static_cast<double>(model::twiceArea(model::discretise(document, body, {500.0, false}))) / 2e12;
            found.emplace_back(std::round(area), layer.thickness);
        }
    }
    return found;
}

}  // namespace

class ZonesTest : public QObject {
    Q_OBJECT

private slots:
    void aZoneHasANameLayersAndAnOutline() {
        Diagnostics diagnostics;
        const auto file = parse("ID=4\nF 2\nZONE Rigid left;UID=7\nLYR 1 2\nLYR top 5 ;x\n" + kSquare +
                                    "U INCH\nZONE b\nS P 0\nOB 0 0 I\nOS 0 1\nOS 1 1\nOS 0 0\nOE\nSE\n",
                                diagnostics);
        QVERIFY(diagnostics.entries().empty());
        QCOMPARE(file.zones.size(), std::size_t{2});
        QCOMPARE(file.zones[0].name, std::string("Rigid left"));
        QCOMPARE(file.zones[0].line, 3U);
        QCOMPARE(file.zones[0].layers, (std::vector<std::string>{"1", "2", "top", "5"}));
        QCOMPARE(file.outlines.shapes[file.zones[0].outline.row()].box.max, (model::Point{10'000'000, 10'000'000}));
        QVERIFY(file.zones[1].layers.empty());
        QCOMPARE(file.outlines.shapes[file.zones[1].outline.row()].box.max, (model::Point{25'400'000, 25'400'000}));
    }

    void whatIsWrongIsToldAndTheRestKept() {
        Diagnostics diagnostics;
        const auto file = parse("LYR 1\n" + kSquare + "FOO 1\nZONE a\n" + kSquare + kSquare +
                                    "ZONE b\nS P 0\nOB 0 0 I\nOS 0 10\nOS 10 10\nOS 0 0\nOE\nZONE c\n",
                                diagnostics);
        QCOMPARE(file.zones.size(), std::size_t{3});
        QVERIFY(file.zones[0].outline.isValid());
        QVERIFY(file.zones[1].outline.isValid());  // without SE
        QVERIFY(!file.zones[2].outline.isValid());
        for (const char* text : {"LYR: there is no zone", "S: there is no zone", "unknown kind", "two outlines"}) {
            QVERIFY2(findDiagnostic(diagnostics, text) != nullptr, text);
        }
    }

    void numbersOfLayersBeginWhereMoreOfThemAreInTheStack() {
        model::odb::Matrix matrix;
        const auto add = [&](int row, LayerType type, const char* name) {
            model::odb::MatrixLayer layer;
            layer.row = row;
            layer.type = type;
            layer.name = name;
            matrix.layers.push_back(std::move(layer));
        };
        add(1, LayerType::Component, "comp");
        add(2, LayerType::Signal, "top");
        add(3, LayerType::Signal, "bot");
        add(4, LayerType::Document, "notes");
        Diagnostics diagnostics;
        const auto rows = [&](const std::string& layers) {
            return model::odb::rowsOfZones(parse("ZONE a\nLYR " + layers + "\n", diagnostics), matrix);
        };
        QCOMPARE(rows("1 2").rows[0], (std::vector<std::size_t>{1, 2}));
        QVERIFY(rows("1 2").countsFromZero);
        QCOMPARE(rows("3 2 2").rows[0], (std::vector<std::size_t>{1, 2}));
        QVERIFY(!rows("3 2").countsFromZero);
        QCOMPARE(rows("Bot TOP").rows[0], (std::vector<std::size_t>{1, 2}));
        QVERIFY(!rows("BOT").hasNumbers);
        QCOMPARE(rows("1 99 nowhere").unknown.size(), std::size_t{2});
        add(5, LayerType::SolderMask, "smb");
        matrix.layers[3].type = LayerType::SolderMask;
        QVERIFY(!rows("2 3 4").countsFromZero);  // as 3 4 5 would be in the stackup too, but not all copper
        QVERIFY(rows("1 2 3").countsFromZero);
    }

    void layersExistInTheZonesThatHaveThem() {
        const auto d = read(dataJob("rigid_flex"));
        QCOMPARE(d->zones.size(), std::size_t{3});
        QCOMPARE(d->zones[2].name, std::string("Stiffened end"));
        QCOMPARE(areaOf(*d, d->zones[2].shape), 400.0);
        QVERIFY(d->zones[2].has(d->findLayer("plate")) && !d->zones[1].has(d->findLayer("plate")));
        for (const char* rigid : {"smt", "top", "prepreg1", "prepreg2", "bot"}) {
            QCOMPARE(areaOf(*d, rigid), 800.0);
        }
        for (const char* everywhere : {"l2", "core", "l3", "through"}) {
            QCOMPARE(areaOf(*d, everywhere), 0.0);
        }
        QCOMPARE(areaOf(*d, "cover"), 1200.0);  // two zones side by side
        QCOMPARE(areaOf(*d, "plate"), 400.0);
        QCOMPARE(layerOf(*d, "top").profile, layerOf(*d, "bot").profile);
        QVERIFY(findDiagnostic(d->diagnostics, "from 0") != nullptr);
        QVERIFY(findDiagnostic(d->diagnostics, "an even share of an assumed board") != nullptr);
        QCOMPARE(d->diagnostics.count(model::Severity::Warning), std::size_t{1});
    }

    void theLaminateIsWhereItsLayersAre() {
        const auto d = read(dataJob("rigid_flex"));
        const auto bodies = bodiesOf(*d);
        QCOMPARE(bodies.size(), std::size_t{3});
        // Beside the inner copper only where prepreg is: in the flexible part it is the outermost.
        const auto sum = [&](const char* a, const char* b) {
            return layerOf(*d, a).thickness + layerOf(*d, b).thickness;
        };
        QCOMPARE(bodies[0], (std::pair{800.0, sum("prepreg1", "l2")}));
        QCOMPARE(bodies[1], (std::pair{2000.0, layerOf(*d, "core").thickness}));
        QCOMPARE(bodies[2], (std::pair{800.0, sum("l3", "prepreg2")}));
    }

    void coverlayLiesOnFlexibleCopperAndStiffenersOnWhatIsThere() {
        const auto d = read(dataJob("rigid_flex"));
        const Layer& flex = layerOf(*d, "l2");
        QCOMPARE(layerOf(*d, "cover").z, flex.z + flex.thickness);
        QCOMPARE(layerOf(*d, "cover").side, model::LayerSide::Inner);
        QVERIFY(findDiagnostic(d->diagnostics, "layer COVER lies between copper layers") != nullptr);
        const Layer& glue = layerOf(*d, "glue");
        const Layer& plate = layerOf(*d, "plate");
        QCOMPARE(glue.z + glue.thickness, 0);
        QCOMPARE(plate.z + plate.thickness, glue.z);
        QCOMPARE(plate.thickness, 200'000);
        QCOMPARE(plate.side, model::LayerSide::Bottom);
        QVERIFY(findDiagnostic(d->diagnostics, "stiffener 200") != nullptr);
    }

    void aLayersOwnProfileCountsMoreThanZones() {
        Folder folder;
        folder.copyJob("rigid_flex");
        folder.write("steps/board/layers/top/profile", "UNITS=MM\n" + kSquare);
        const auto d = read(folder.path());
        QCOMPARE(areaOf(*d, "top"), 100.0);
        QCOMPARE(areaOf(*d, "bot"), 800.0);
    }

    void zonesThatSayTooLittleBoundNothing() {
        Folder folder;
        folder.copyJob("rigid_flex");
        folder.write("steps/board/zones", "UNITS=MM\nZONE a\nLYR 1 8\n" + kSquare + "ZONE b\nLYR 1 77\n");
        const auto d = read(folder.path());
        QCOMPARE(d->zones.size(), std::size_t{2});
        QCOMPARE(areaOf(*d, "top"), 0.0);
        QCOMPARE(bodiesOf(*d).size(), std::size_t{1});
        for (const char* text : {"zone without an outline", "names a layer that is not in the matrix",
                                 "no zone has are taken to be all over the board: PREPREG1, L2, CORE, L3, PREPREG2"}) {
            QVERIFY2(findDiagnostic(d->diagnostics, text) != nullptr, text);
        }
    }

    /// The same card placed on a panel that has no zones itself: rows and heights are those of the card.
    void stepsOfAPanelHaveTheSameSlabs() {
        Folder folder;
        folder.copyJob("rigid_flex");
        fs::rename(folder.path() / "steps/board", folder.path() / "steps/card");
        folder.write("steps/panel/stephdr",
                     "STEP-REPEAT {\nNAME=card\nX=10\nY=10\nDX=0\nDY=0\nNX=1\nNY=1\nANGLE=0\n}\n"
                     "UNITS=MM\n");
        folder.write("steps/panel/profile",
                     "UNITS=MM\nS P 0\nOB 0 0 I\nOS 0 50\nOS 200 50\nOS 200 0\nOS 0 0\nOE\nSE\n");
        const auto panel = read(folder.path(), "panel");
        QCOMPARE(panel->steps.size(), std::size_t{1});
        const auto own = bodiesOf(*panel);
        const auto card = bodiesOf(*panel->steps[0]);
        QCOMPARE(own.size(), std::size_t{3});
        QCOMPARE(card.size(), std::size_t{3});
        for (std::size_t i = 0; i < own.size(); ++i) {
            QCOMPARE(own[i].second, card[i].second);
            QCOMPARE(own[i].first, 10'000.0 - 2'000.0);
        }
        QCOMPARE(card[0].first, 800.0);
        QCOMPARE(card[1].first, 2000.0);
    }
};

QTEST_APPLESS_MAIN(ZonesTest)
#include "zones_test.moc"
