// What each row of a stackup is, which parts of the board have it, and how the thicknesses add up.

#include "model/board/stackup_table.h"

#include <QtTest>

#include "model/board/stackup.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Nm;
using model::StackupKind;
using model::Substack;
using odb_testing::dataJob;
using odb_testing::Folder;
using odb_testing::read;

namespace {

std::size_t rowOf(const model::Document& document, const char* name) {
    return static_cast<std::size_t>(model::findRow(document.stackup, name) - document.stackup.rows.data());
}

QStringList rowsOf(const model::Document& document, const Substack& part) {
    QStringList names;
    for (std::size_t i = 0; i < part.has.size(); ++i) {
        if (part.has[i]) {
            names += QString::fromStdString(document.stackup.rows[i].name);
        }
    }
    return names;
}

std::string kindOf(const model::Document& document, const char* name) {
    return toString(model::kindOf(*model::findRow(document.stackup, name), document));
}

/// A job of layers "TYPE NAME" of which the words say more: "MASK BEND\n ADD_TYPE=BEND_AREA".
std::shared_ptr<const model::Document> jobOf(const std::vector<std::pair<std::string, std::string>>& layers,
                                             const std::vector<std::string>& drawn = {}) {
    const Folder folder;
    odb_testing::writeSmallJob(folder, "UNITS=MM\n");
    folder.write("matrix/matrix", odb_testing::matrixOf(layers));
    for (const std::string& name : drawn) {
        folder.write("steps/board/layers/" + name + "/features", "UNITS=MM\n$0 r100\nP 5 5 0 P 0 0\n");
    }
    return read(folder.path());
}

}  // namespace

class StackupTableTest : public QObject {
    Q_OBJECT

private slots:
    void rowsSayWhatTheyAre() {
        const auto flex = read(dataJob("rigid_flex"));
        QCOMPARE(kindOf(*flex, "SMT"), "solder_mask");
        QCOMPARE(kindOf(*flex, "COVER"), "coverlay");
        QCOMPARE(kindOf(*flex, "GLUE"), "adhesive");
        QCOMPARE(kindOf(*flex, "PLATE"), "stiffener");
        QCOMPARE(kindOf(*flex, "L2"), "copper");
        QCOMPARE(kindOf(*flex, "CORE"), "dielectric");  // its name is no statement
        const auto board = jobOf({{"CONDUCTIVE_PASTE", "TOP_FINISH"},
                                  {"CONDUCTIVE_PASTE", "CARBON"},
                                  {"SIGNAL", "TOP"},
                                  {"DIELECTRIC", "D1\n DIELECTRIC_TYPE=CORE"},
                                  {"SIGNAL", "MID"},
                                  {"DIELECTRIC", "D2\n DIELECTRIC_TYPE=Prepreg"},
                                  {"SIGNAL", "BOT"}},
                                 {"top_finish", "carbon"});
        QCOMPARE(kindOf(*board, "TOP_FINISH"), "finish");
        QCOMPARE(kindOf(*board, "CARBON"), "conductive_paste");
        QCOMPARE(kindOf(*board, "D1"), "core");
        QCOMPARE(kindOf(*board, "D2"), "prepreg");
    }

    void aBoardWithoutZonesIsOneStackup() {
        const auto d = read(dataJob("everything"));
        const std::vector<Substack> parts = model::substacksOf(*d);
        QCOMPARE(parts.size(), std::size_t{1});
        QCOMPARE(parts[0].name, "");
        QCOMPARE(parts[0].copperToCopper, d->boardThickness);
        Nm masks = 0;
        Nm sum = 0;
        for (std::size_t i = 0; i < d->stackup.rows.size(); ++i) {
            const model::StackupRow& row = d->stackup.rows[i];
            const bool isMask = row.type == model::LayerType::SolderMask;
            const bool isCounted = isMask || row.type == model::LayerType::Dielectric || d->layer(row.layer).isCopper();
            masks += isMask ? row.thickness : 0;
            sum += isCounted ? row.thickness : 0;
            QCOMPARE(parts[0].cumulative[i], isCounted ? std::optional(sum) : std::nullopt);
        }
        QVERIFY(masks > 0);
        QCOMPARE(parts[0].overall, d->boardThickness + masks);
    }

    void zonesAreStackupsOfTheirOwn() {
        const auto d = read(dataJob("rigid_flex"));
        const std::vector<Substack> parts = model::substacksOf(*d);
        QCOMPARE(parts.size(), std::size_t{3});
        QCOMPARE(parts[0].name, "Rigid");
        QCOMPARE(rowsOf(*d, parts[0]), QStringList({"SMT", "TOP", "PREPREG1", "L2", "CORE", "L3", "PREPREG2", "BOT"}));
        QCOMPARE(rowsOf(*d, parts[1]), QStringList({"COVER", "L2", "CORE", "L3"}));
        QCOMPARE(rowsOf(*d, parts[2]), QStringList({"COVER", "L2", "CORE", "L3", "GLUE", "PLATE"}));
        const auto thick = [&](const char* name) { return d->stackup.rows[rowOf(*d, name)].thickness; };
        const Nm flexible = thick("L2") + thick("CORE") + thick("L3");
        QCOMPARE(parts[0].copperToCopper, d->boardThickness);
        QCOMPARE(parts[0].overall, d->boardThickness + thick("SMT"));
        QCOMPARE(parts[1].copperToCopper, flexible);
        QCOMPARE(parts[1].overall, thick("COVER") + flexible);
        QCOMPARE(parts[2].overall, thick("COVER") + flexible + thick("GLUE") + thick("PLATE"));
        QVERIFY(!parts[1].cumulative[rowOf(*d, "TOP")]);
        QCOMPARE(parts[1].cumulative[rowOf(*d, "L2")], std::optional(thick("COVER") + thick("L2")));
    }

    void aDielectricWithoutALayerIsWhereItsCopperIs() {
        auto d = std::make_shared<model::Document>(*jobOf({{"SIGNAL", "A"}, {"SIGNAL", "B"}, {"SIGNAL", "C"}}));
        d->zones = {{"all", {d->findLayer("A"), d->findLayer("B"), d->findLayer("C")}, {}},
                    {"end", {d->findLayer("B"), d->findLayer("C")}, {}}};
        const std::vector<Substack> parts = model::substacksOf(*d);
        QCOMPARE(rowsOf(*d, parts[0]), QStringList({"A", "below A", "B", "below B", "C"}));
        QCOMPARE(rowsOf(*d, parts[1]), QStringList({"B", "below B", "C"}));
        d->zones = {{"part", {d->findLayer("A"), d->findLayer("B")}, {}}};  // C is in no zone
        QCOMPARE(rowsOf(*d, model::substacksOf(*d)[0]), QStringList({"A", "below A", "B", "below B", "C"}));
    }

    void aSingleCopperLayersSubstrateIsTheBoard() {
        const auto d = jobOf({{"SOLDER_MASK", "SM"}, {"SIGNAL", "TOP"}});
        const Substack part = model::substacksOf(*d)[0];
        QCOMPARE(part.copperToCopper, d->boardThickness);
        QCOMPARE(part.overall, d->boardThickness + model::kDefaultCopper + model::kDefaultMask);
    }

    void markersAndEmptyMasksAreNoLayersOfTheStackup() {
        const auto d = jobOf({{"MASK", "BEND\n ADD_TYPE=BEND_AREA"},
                              {"CONDUCTIVE_PASTE", "FINISH"},
                              {"SIGNAL", "TOP"},
                              {"DIELECTRIC", "D"},
                              {"MASK", "FLEX\n ADD_TYPE=FLEX_AREA"},
                              {"SIGNAL", "BOT"},
                              {"MASK", "PLATE\n ADD_TYPE=STIFFENER"},
                              {"MASK", "PEEL"}},
                             {"bend", "flex", "top", "peel"});
        QCOMPARE(rowsOf(*d, model::substacksOf(*d)[0]), QStringList({"TOP", "D", "BOT", "PLATE", "PEEL"}));
        for (const char* name : {"BEND", "FLEX", "FINISH"}) {
            QCOMPARE(odb_testing::layerOf(*d, name).thickness, 0);
        }
        QVERIFY(odb_testing::findDiagnostic(d->diagnostics, "process steps are not part of the stackup: BEND, FLEX"));
        QVERIFY(odb_testing::findDiagnostic(d->diagnostics, "draw nothing are not part of the stackup: FINISH"));
        QVERIFY(!odb_testing::findDiagnostic(d->diagnostics, "below the bottom side"));
    }

    void nothingHasNoStackup() { QVERIFY(model::substacksOf(model::Document()).empty()); }
};

QTEST_APPLESS_MAIN(StackupTableTest)
#include "stackup_table_test.moc"
