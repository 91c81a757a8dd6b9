// Every check finds what it is for and passes what lies within its limit; what is assumed is no finding.

#include "model/board/stackup_checks.h"

#include <QtTest>

#include "model/solids/restack.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::LayerType;
using model::Nm;
using model::Severity;
using model::Source;
using model::StackupCheck;
using model::StackupFinding;

namespace {

/// Rows without layers: nothing but the stackup is checked.
struct Rows {
    model::Document document;

    Rows& add(const char* name, LayerType type, Nm thickness, Source source = Source::Job) {
        document.stackup.rows.push_back({name, {}, type, 0, thickness, source, {}});
        return *this;
    }
    Rows& copper(const char* name, Nm thickness, Source source = Source::Job) {
        return add(name, LayerType::Signal, thickness, source);
    }
    Rows& dielectric(const char* name, Nm thickness, const char* type = "") {
        add(name, LayerType::Dielectric, thickness);
        last().type = type;
        return *this;
    }
    Rows& mask(const char* name, Nm thickness, Source source = Source::Job) {
        return add(name, LayerType::SolderMask, thickness, source);
    }
    model::Material& last() { return document.stackup.rows.back().material; }
    Rows& board(double nm) {
        document.stackup.facts.boardNm = nm;
        return *this;
    }
    [[nodiscard]] QStringList found() const {
        QStringList checks;
        for (const StackupFinding& finding : model::checkStackup(document)) {
            checks += toString(finding.check);
        }
        return checks;
    }
    [[nodiscard]] StackupFinding first() const { return model::checkStackup(document).at(0); }
};

Rows fourLayers() {
    Rows rows;
    rows.mask("SMT", 25'000).copper("TOP", 35'000).dielectric("D1", 200'000, "PREPREG").copper("L2", 17'500);
    rows.dielectric("D2", 1'000'000, "CORE").copper("L3", 17'500).dielectric("D3", 200'000, "PREPREG");
    return rows.copper("BOT", 35'000).mask("SMB", 25'000);
}

}  // namespace

class StackupChecksTest : public QObject {
    Q_OBJECT

private slots:
    void aCommonBoardHasNoFindings() {
        QCOMPARE(fourLayers().board(1'505'000).found(), QStringList());
        QCOMPARE(Rows().found(), QStringList());
    }

    void sumsThatDisagree() {
        Rows rows = fourLayers().board(1'555'000);
        QCOMPARE(rows.found(), QStringList({"sum"}));
        QCOMPARE(rows.first().severity, Severity::Info);
        QCOMPARE(rows.first().text,
                 "Copper and dielectrics add up to 1.505 mm, but by the job's thickness of the board they would be "
                 "1.555 mm; "
                 "the layers are used");
        QCOMPARE(fourLayers().board(2'000'000).first().severity, Severity::Warning);
        QCOMPARE(fourLayers().board(1'508'000).found(), QStringList());  // what an ounce is differs
        rows.document.stackup.rows[1].source = Source::Derived;          // from the board's thickness
        QCOMPARE(rows.found(), QStringList());
    }

    /// Formats that count the masks have 1.6 mm in their file here.
    void aSumThatDisagreesNamesTheThicknessWithMasksToo() {
        Rows rows = fourLayers().board(1'550'000);
        for (const LayerType type : {LayerType::SolderMask, LayerType::Signal, LayerType::SolderMask}) {
            rows.document.layers.emplace_back().type = type;
            rows.document.stackup.facts.layers.emplace_back().thicknessNm = 25'000;
        }
        QCOMPARE(rows.first().text,
                 "Copper and dielectrics add up to 1.505 mm, but by the job's thickness of the board they would be "
                 "1.55 mm, with its solder masks 1.6 mm; the layers are used");
    }

    void dielectricsOnTheOuterCopperCountIfTheJobCountsThem() {
        const auto withFilms = [](double board) {
            Rows rows = Rows().dielectric("F1", 12'700, "PREPREG");
            const Rows inner = fourLayers();
            for (const model::StackupRow& row : inner.document.stackup.rows) {
                rows.document.stackup.rows.push_back(row);
            }
            return rows.dielectric("F2", 12'700, "PREPREG").board(board);
        };
        QCOMPARE(withFilms(1'530'400).found(), QStringList());
        QCOMPARE(withFilms(1'505'000).found(), QStringList());
        QVERIFY(withFilms(1'600'000).first().text.starts_with("Copper and dielectrics add up to 1.5304 mm, but"));
        QVERIFY(withFilms(1'450'000).first().text.starts_with("Copper and dielectrics add up to 1.505 mm, but"));
        Rows rows = withFilms(1'530'400);
        rows.document.stackup.rows.front().source = Source::Assumed;
        QCOMPARE(rows.found(), QStringList({"sum"}));
    }

    void anAbsurdThicknessOfTheBoardIsNotJudged() {
        QCOMPARE(fourLayers().board(100).found(), QStringList());
        QCOMPARE(fourLayers().board(1e12).found(), QStringList());
        QCOMPARE(fourLayers().board(1'000).found(), QStringList({"sum"}));
    }

    void masksThatNobodyMakes() {
        Rows rows = Rows().mask("SMT", 254'000).copper("TOP", 35'000).mask("SMB", 25'000, Source::Assumed);
        QCOMPARE(rows.found(), QStringList({"mask_thickness"}));
        QCOMPARE(rows.first().text, "Solder mask SMT 254 µm: no solder mask is thicker than 100 µm");
        QCOMPARE(rows.first().rows, (std::vector<std::size_t>{0}));
        rows.document.stackup.rows[2].source = Source::Job;
        QCOMPARE(rows.found(), QStringList({"mask_thickness", "mask_sides"}));
        QCOMPARE(Rows().mask("SMT", 40'000).copper("TOP", 35'000).mask("SMB", 20'000).found(), QStringList());
        QCOMPARE(Rows().mask("SMT", 41'000).copper("TOP", 35'000).mask("SMB", 20'000).found(),
                 QStringList({"mask_sides"}));
        QCOMPARE(Rows().mask("SMT", 254'000, Source::Assumed).found(), QStringList());
    }

    void numbersThatNoMaterialHas_data() {
        QTest::addColumn<int>("row");
        QTest::addColumn<int>("thickness");
        QTest::addColumn<QString>("check");
        QTest::newRow("foil too thin") << 3 << 4'999 << "copper_thickness";
        QTest::newRow("thinnest foil") << 3 << 5'000 << "";
        QTest::newRow("foil too thick") << 3 << 480'001 << "copper_thickness";
        QTest::newRow("dielectric too thin") << 4 << 11'999 << "dielectric_thickness";
        QTest::newRow("thinnest film") << 4 << 12'000 << "";
    }
    void numbersThatNoMaterialHas() {
        QFETCH(int, row);
        QFETCH(int, thickness);
        QFETCH(QString, check);
        Rows rows = fourLayers();
        rows.document.stackup.rows[static_cast<std::size_t>(row)].thickness = thickness;
        QCOMPARE(rows.found().contains(check), !check.isEmpty());
        QCOMPARE(rows.found().filter("thickness").size(), check.isEmpty() ? 0 : 1);
        rows.document.stackup.rows[static_cast<std::size_t>(row)].source = Source::Assumed;
        QVERIFY(rows.found().filter("thickness").isEmpty());
    }

    void propertiesThatNoMaterialHas() {
        Rows rows = fourLayers();
        model::Material& core = rows.document.stackup.rows[4].material;
        core.dielectricConstant = 2.1;
        core.lossTangent = 0.05;
        QCOMPARE(rows.found(), QStringList());
        core.dielectricConstant = 42;
        core.lossTangent = 0.2;
        QCOMPARE(rows.found(), QStringList({"dielectric_constant", "loss_tangent"}));
        QCOMPARE(rows.first().text, "D2: a Dk of 42; materials have 1.9 to 13");
        core.dielectricConstant = 1.5;
        core.lossTangent = {};
        QCOMPARE(rows.found(), QStringList({"dielectric_constant"}));
    }

    void coresCannotBeBondedToCores() {
        Rows rows = fourLayers();
        rows.document.stackup.rows[2].material.type = "CORE";
        QCOMPARE(rows.found(), QStringList({"core_on_core"}));
        QCOMPARE(rows.first().text, "Copper between two cores, which only prepreg can bond: L2");
        QCOMPARE(rows.first().rows, (std::vector<std::size_t>{3}));
        rows.document.stackup.rows[6].material.type = "CORE";
        QCOMPARE(model::checkStackup(rows.document).size(), std::size_t{1});
        QVERIFY(rows.first().text.ends_with(": L2, L3"));
    }

    void halvesThatDiffer() {
        Rows rows = fourLayers();
        rows.document.stackup.rows[6].thickness = 223'000;
        QCOMPARE(rows.found(), QStringList({"symmetry"}));
        QCOMPARE(rows.first().severity, Severity::Info);
        QCOMPARE(rows.first().text, "The stackup is not symmetric about its middle: D1 200 µm and D3 223 µm");
        QCOMPARE(rows.first().rows, (std::vector<std::size_t>{2, 6}));
        rows.document.stackup.rows[6].thickness = 222'000;  // within a tenth
        QCOMPARE(rows.found(), QStringList());
    }

    void whatLiesBetweenTwoCoppersCountsTogether() {
        const auto split = [](const char* name) {
            Rows rows;
            rows.copper("TOP", 35'000).dielectric("D1", 200'000).dielectric("D2", 100'000);
            rows.document.stackup.rows[1].material.name = "FR4";
            rows.document.stackup.rows[2].material.name = name;
            rows.copper("L2", 17'500).dielectric("D3", 800'000).copper("L3", 17'500).dielectric("D4", 300'000);
            rows.document.stackup.rows[6].material.name = "FR4";
            return rows.copper("BOT", 35'000);
        };
        Rows rows = split("FR4");
        QCOMPARE(rows.found(), QStringList());
        rows.document.stackup.rows[6].thickness = 400'000;
        QCOMPARE(rows.first().text,
                 "The stackup is not symmetric about its middle: D1 and D2 together 300 µm and D4 400 µm");
        QCOMPARE(rows.first().rows, (std::vector<std::size_t>{1, 2, 6}));
        QCOMPARE(split("PTFE").found(), QStringList({"symmetry"}));
    }

    void onlySomeOfManyPairsAreNamed() {
        Rows rows;
        for (int i = 0; i < 5; ++i) {
            rows.copper("c", 10'000 * (i + 1)).dielectric("d", 100'000 * (i + 1));
        }
        rows.copper("last", 100'000);
        QCOMPARE(rows.found(), QStringList({"symmetry"}));
        QVERIFY(rows.first().text.ends_with(" and 2 more pairs"));
        QCOMPARE(rows.first().rows.size(), std::size_t{10});
    }

    void zonesAreLookedAtOneByOne() {
        auto d = std::make_shared<model::Document>(*odb_testing::read(odb_testing::dataJob("rigid_flex")));
        for (model::StackupRow& row : d->stackup.rows) {
            row.source = Source::Job;
        }
        QVERIFY(model::checkStackup(*d).empty());
        const auto copper = std::ranges::find(d->stackup.rows, "L3", &model::StackupRow::name);
        copper->thickness = 70'000;
        const std::vector<StackupFinding> findings = model::checkStackup(*d);
        QCOMPARE(findings.size(), std::size_t{3});
        QVERIFY(findings[1].text.starts_with("The stackup of zone Flex is not symmetric"));
    }

    void findingsAreMessagesUntilTheyAreEditedAway() {
        const auto board = odb_testing::read(odb_testing::dataJob("everything"));
        const auto edited = model::restack(*board, {{"SMT", 254'000}});
        QVERIFY(!odb_testing::findDiagnostic(board->diagnostics, "no solder mask is thicker"));
        QVERIFY(odb_testing::findDiagnostic(edited->diagnostics, "no solder mask is thicker"));
        const auto back = model::restack(*edited, {});
        QVERIFY(!odb_testing::findDiagnostic(back->diagnostics, "no solder mask is thicker"));
    }
};

QTEST_APPLESS_MAIN(StackupChecksTest)
#include "stackup_checks_test.moc"
