#include "model/formats/odb/stackup/stackup_xml.h"

#include <QtTest>

#include "model/board/stackup.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Diagnostics;
using model::LayerFacts;
using model::Source;
using model::StackupFacts;
using model::odb::StackupXml;
using odb_testing::findDiagnostic;

namespace {

/// Four materials and, between TOP and BOTTOM, a core and a ply that the matrix of the tests does not have.
const std::string kFile = R"(<?xml version="1.0" encoding="UTF-8"?>
<StackupFile Version="8.1" DefaultUnits="MM">
  <EdaData CompanyName="Nobody">
    <Specs>
      <Spec SpecName="Main">
        <Material MaterialName="Foil"><Conductor ConductorType="COPPER" CopperWeight_oz_ft2="0.5">
            <Properties PropertyName="default"><Property Conductivity_mho_cm="595900"/></Properties></Conductor>
          <Default_Thickness Thickness="0.0175"/></Material>
        <Material MaterialName="Heavy"><Conductor ConductorType="COPPER" CopperWeight_oz_ft2="2"/></Material>
        <Material MaterialName="Core"><Dielectric DielectricType="CORE">
            <Properties PropertyName="dry"><Property FrequencyVal="1" DielectricConstant_Dk="4.4" LossTangent_Df="0.02"/>
              <Property FrequencyVal="10" DielectricConstant_Dk="4.1" LossTangent_Df="0.025"/></Properties></Dielectric>
          <Default_Thickness Thickness="12" Finished_Thickness="10" Units="MIL"/></Material>
        <Material MaterialName="Ply"><Dielectric DielectricType="PREPREG">
            <Properties><Property Thickness="90" Units_Thickness="MICRON"/></Properties></Dielectric></Material>
      </Spec>
    </Specs>
    <Stackup StackupName="pcb" StackupThickness="0.5">
      <Group GroupName="all">
        <Layer LayerName="top" LayerType="SIGNAL"><SpecRef MaterialSpecName="Main"><Material MaterialName="Foil"/></SpecRef></Layer>
        <Layer LayerName="c1" LayerType="DIELECTRIC"><SpecRef MaterialSpecName="Main"><Material MaterialName="Core" PropertyName="dry" FrequencyVal="10"/></SpecRef></Layer>
        <Layer LayerName="p1" LayerType="DIELECTRIC"><SpecRef MaterialSpecName="Main"><Material MaterialName="Ply"/></SpecRef></Layer>
        <Layer LayerName="BOTTOM" LayerType="SIGNAL"><SpecRef MaterialSpecName="Main"><Material MaterialName="Heavy"/></SpecRef></Layer>
        <Layer LayerName="gone" LayerType="SIGNAL"><SpecRef MaterialSpecName="Main"><Material MaterialName="Gold"/></SpecRef></Layer>
      </Group>
    </Stackup>
  </EdaData>
</StackupFile>
)";

StackupXml parse(const std::string& text, Diagnostics& diagnostics) {
    return model::odb::parseStackupXml(text, "matrix/stackup.xml", diagnostics);
}

std::shared_ptr<const model::Document> boardWith(const std::string& xml, const std::string& attributes = {}) {
    const odb_testing::Folder folder;
    odb_testing::writeSmallJob(folder, "UNITS=MM\n$0 r100\nP 1 1 0 P 0 0\n");
    folder.write("matrix/matrix", odb_testing::matrixOf({{"SIGNAL", "TOP"}, {"SIGNAL", "BOTTOM"}}));
    folder.write("matrix/stackup.xml", xml);
    if (!attributes.empty()) {
        folder.write("steps/board/layers/top/attrlist", attributes);
    }
    return odb_testing::read(folder.path());
}

}  // namespace

class StackupXmlTest : public QObject {
    Q_OBJECT

private slots:
    void layersFollowTheirReferences() {
        Diagnostics diagnostics;
        const StackupXml xml = parse(kFile, diagnostics);
        QCOMPARE(xml.layers.size(), std::size_t{5});
        QCOMPARE(*xml.boardNm, 500'000.0);
        QCOMPARE(*xml.layers[0].thicknessNm, 17'500.0);
        QCOMPARE(*xml.layers[0].material.copperOz, 0.5);
        QVERIFY(std::abs(*xml.layers[0].material.resistivity - 16.78) < 0.01);
        QCOMPARE(*xml.layers[1].thicknessNm, 254'000.0);  // the finished one, in its own unit
        QCOMPARE(xml.layers[1].material.type, "CORE");
        QCOMPARE(*xml.layers[1].material.dielectricConstant, 4.1);  // at the frequency asked for
        QCOMPARE(*xml.layers[1].material.lossTangent, 0.025);
        QCOMPARE(*xml.layers[2].thicknessNm, 90'000.0);
        QCOMPARE(*xml.layers[3].thicknessNm, 2 * base::kNmPerOunce);  // from the weight alone
        QVERIFY(!xml.layers[4].thicknessNm);
        const auto* missing = findDiagnostic(diagnostics, "layer gone: its material is not in the file");
        QVERIFY(missing != nullptr);
        QCOMPARE(missing->line, 24U);
    }

    void dielectricsWithoutARowAddUp() {
        const auto document = boardWith(kFile);
        const auto& rows = document->stackup.rows;
        QCOMPARE(rows.size(), std::size_t{3});
        QCOMPARE(rows[0].thickness, 17'500);
        QCOMPARE(rows[1].name, "below TOP");
        QCOMPARE(rows[1].thickness, 254'000 + 90'000);
        QCOMPARE(rows[1].source, Source::Job);
        QCOMPARE(rows[1].material.name, "Core + Ply");
        QCOMPARE(rows[2].thickness, 69'600);
        QVERIFY(findDiagnostic(document->diagnostics, "layer gone is not in the matrix") != nullptr);
        QVERIFY(findDiagnostic(document->diagnostics, "add up to 431.1 µm") != nullptr);
    }

    void contradictionsAreReportedAndTheFileIsBelieved() {
        const auto document = boardWith(kFile, "UNITS=MM\n.copper_weight=35\n.layer_dielectric=1\n");
        QCOMPARE(document->stackup.rows[0].thickness, 17'500);
        QCOMPARE(document->stackup.rows[1].thickness, 344'000);
        const auto* message = findDiagnostic(document->diagnostics, "the thickness of layer top is not what");
        QVERIFY(message != nullptr);
        QCOMPARE(message->file, "matrix/stackup.xml");
        QCOMPARE(message->line, 20U);
        const auto agrees = boardWith(kFile, "UNITS=MM\n.copper_weight=17.4\n");
        QVERIFY(findDiagnostic(agrees->diagnostics, "is not what the attributes say") == nullptr);
    }

    void whatIsNoStackupLeavesTheAttributes() {
        for (const char* text :
             {"", "no xml", "<a><b></a>", "<StackupFile/>", "<StackupFile><EdaData/></StackupFile>"}) {
            const auto document = boardWith(text, "UNITS=MM\n.copper_weight=20\n");
            QCOMPARE(document->stackup.rows[0].thickness, 20'000);
            QVERIFY(findDiagnostic(document->diagnostics, "the attributes are used instead") != nullptr);
        }
    }

    void everyTruncatedPrefixIsSurvived() {
        for (std::size_t length = 0; length < kFile.size(); length += 7) {
            Diagnostics diagnostics;
            const StackupXml xml = parse(kFile.substr(0, length), diagnostics);
            QVERIFY(xml.layers.empty() && !diagnostics.entries().empty());
        }
    }
};

QTEST_APPLESS_MAIN(StackupXmlTest)
#include "stackup_xml_test.moc"
