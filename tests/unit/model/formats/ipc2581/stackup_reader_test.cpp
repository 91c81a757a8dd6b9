#include "model/formats/ipc2581/stackup_reader.h"

#include <QtTest>

#include "tests/unit/model/formats/ipc2581/ipc_files.h"

using namespace ipc_files;
using model::LayerType;
using model::LayerUse;
using model::formats::DrawnLayer;

namespace {

/// Layers from the top, which are all rows of one stackup, 0.1 mm each.
std::string fileOf(const std::vector<std::pair<std::string, std::string>>& layers) {
    std::string list;
    std::string rows;
    for (const auto& [name, function] : layers) {
        list += "<Layer name='" + name + "' layerFunction='" + function + "'/>";
        rows += "<StackupLayer layerOrGroupRef='" + name + "' thickness='0.1'/>";
    }
    return "<IPC-2581 revision='C'><Content/><Ecad><CadHeader units='MILLIMETER'/><CadData>" + list +
           "<Stackup name='p'><StackupGroup name='g'>" + rows +
           "</StackupGroup></Stackup><Step name='s'></Step></CadData></Ecad></IPC-2581>";
}

}  // namespace

class StackupReaderTest : public QObject {
    Q_OBJECT

private slots:
    void whatCarriesTheOnlyCopperIsNoStiffener() {
        const auto job =
            parse(fileOf({{"M", "SOLDERMASK"}, {"F", "DIELCOVERLAY"}, {"T", "CONDUCTOR"}, {"D", "DIELCORE"}}));
        QVERIFY(job);
        const DrawnLayer& carrier = job->layers[layerNamed(*job, "D")];
        QCOMPARE(carrier.type, LayerType::Dielectric);
        QCOMPARE(carrier.use, LayerUse::Plain);
        QCOMPARE(job->layers[layerNamed(*job, "F")].use, LayerUse::Coverlay);
    }

    void aDielectricOutsideOfTheCopperIsAStiffener() {
        const auto job = parse(fileOf({{"T", "CONDUCTOR"}, {"D", "DIELBASE"}, {"B", "CONDUCTOR"}, {"P", "DIELCORE"}}));
        QVERIFY(job);
        QCOMPARE(job->layers[layerNamed(*job, "D")].use, LayerUse::Plain);
        QCOMPARE(job->layers[layerNamed(*job, "P")].use, LayerUse::Stiffener);
    }
};

QTEST_APPLESS_MAIN(StackupReaderTest)
#include "stackup_reader_test.moc"
