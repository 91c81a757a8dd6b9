#include "model/board/layers.h"

#include <QtTest>

#include "model/board/document_builder.h"

using namespace model;

namespace {

Layer layer(const char* name, LayerType type, LayerSide side = LayerSide::None, bool isSynthetic = false) {
    Layer made;
    made.name = name;
    made.type = type;
    made.side = side;
    made.isSynthetic = isSynthetic;
    return made;
}

/// As KiCad and we make them, from the top.
std::shared_ptr<const Document> board() {
    DocumentBuilder builder;
    builder.addLayer(layer("DXF_TOP", LayerType::SilkScreen, LayerSide::Top));
    builder.addLayer(layer("F.SILKSCREEN", LayerType::SilkScreen, LayerSide::Top));
    builder.addLayer(layer("F.PASTE", LayerType::SolderPaste, LayerSide::Top));
    builder.addLayer(layer("F.MASK", LayerType::SolderMask, LayerSide::Top));
    builder.addLayer(layer("F.CU", LayerType::Signal, LayerSide::Top));
    builder.addLayer(layer("CORE", LayerType::Dielectric, LayerSide::Inner));
    builder.addLayer(layer("IN1.CU", LayerType::PowerGround, LayerSide::Inner));
    builder.addLayer(layer("B.CU", LayerType::Signal, LayerSide::Bottom));
    builder.addLayer(layer("F.FAB", LayerType::Document));
    builder.addLayer(layer("EDGE.CUTS", LayerType::Document));
    builder.addLayer(layer("USER.1", LayerType::Document));
    builder.addLayer(layer("DRILL", LayerType::Drill, LayerSide::Through));
    builder.addLayer(layer("(mask)", LayerType::SolderMask, LayerSide::Top, true));
    builder.addLayer(layer("(bodies)", LayerType::ComponentBody, LayerSide::Top, true));
    builder.addLayer(layer("(outline)", LayerType::Profile, LayerSide::None, true));
    return builder.finish();
}

QStringList namesOf(LayerPreset preset) {
    const auto document = board();
    const std::vector<bool> isIn = layersOf(*document, preset);
    QStringList names;
    for (std::size_t row = 0; row < isIn.size(); ++row) {
        if (isIn[row]) {
            names += QString::fromStdString(document->layers[row].name);
        }
    }
    return names;
}

}  // namespace

class LayersTest : public QObject {
    Q_OBJECT

private slots:
    void groupsFollowTypesAndNames() {
        const auto document = board();
        std::vector<LayerGroup> groups;
        for (const Layer& each : document->layers) {
            groups.push_back(groupOf(each));
        }
        using enum LayerGroup;
        const std::vector<LayerGroup> expected = {Other,      Silkscreen, Paste,      SolderMask, Copper,
                                                  Dielectric, Copper,     Copper,     Other,      Mechanical,
                                                  Other,      Drill,      SolderMask, Components, Mechanical};
        QVERIFY(groups == expected);
    }

    void presetsHoldWhatTheirNameSays() {
        QCOMPARE(namesOf(LayerPreset::All).size(), 15);
        QVERIFY(namesOf(LayerPreset::None).isEmpty());
        QCOMPARE(namesOf(LayerPreset::Copper), QStringList({"F.CU", "IN1.CU", "B.CU"}));
        QCOMPARE(namesOf(LayerPreset::Top), QStringList({"F.SILKSCREEN", "F.CU", "DRILL", "(mask)", "(outline)"}));
        QCOMPARE(namesOf(LayerPreset::Bottom), QStringList({"B.CU", "DRILL", "(outline)"}));
        QCOMPARE(namesOf(LayerPreset::Inner), QStringList({"IN1.CU", "DRILL", "(outline)"}));
        QCOMPARE(namesOf(LayerPreset::Assembly), QStringList({"F.SILKSCREEN", "F.FAB", "(bodies)", "(outline)"}));
        QCOMPARE(namesOf(LayerPreset::Fabrication),
                 QStringList({"F.SILKSCREEN", "F.MASK", "F.CU", "IN1.CU", "B.CU", "DRILL", "(outline)"}));
    }

    void drawingIsNoPrintThoughTheJobCallsItSilkscreen() {
        const auto document = board();
        QVERIFY(isDrawingAsSilkscreen(document->layers[0]));
        QVERIFY(!isDrawingAsSilkscreen(document->layers[1]));
        const std::vector<bool> prints = silkscreenPrints(*document);
        QVERIFY(!prints[0] && prints[1]);
    }
};

QTEST_APPLESS_MAIN(LayersTest)
#include "layers_test.moc"
