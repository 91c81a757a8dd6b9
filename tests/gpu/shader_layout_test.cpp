#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <cstddef>

#include "shaders/shared/frame.h"
#include "shaders/shared/raster.h"
#include "shaders/shared/section.h"
#include "shaders/spirv.h"

namespace {

struct Location {
    std::size_t offset = 0;
    std::size_t size = 0;  ///< of the whole struct
    bool operator==(const Location&) const = default;
};

/// "struct.member" -> place, as the C++ compiler lays it out.
const QMap<QString, Location> kCompiled = {
#define MEMBER(name, Struct, member) \
    std::pair(QString(#name "." #member), Location{offsetof(shader::Struct, member), sizeof(shader::Struct)})
    MEMBER(let, Let, p0),
    MEMBER(let, Let, p1),
    MEMBER(let, Let, p2),
    MEMBER(let, Let, p3),
    MEMBER(let, Let, p4),
    MEMBER(let, Let, p5),
    MEMBER(let, Let, meta),
    MEMBER(let, Let, element),
    MEMBER(cluster, Cluster, boxMin),
    MEMBER(cluster, Cluster, boxMax),
    MEMBER(cluster, Cluster, firstLet),
    MEMBER(cluster, Cluster, count),
    MEMBER(cluster, Cluster, layer),
    MEMBER(cluster, Cluster, onlyAs),
    MEMBER(layerState, LayerState, colour),
    MEMBER(layerState, LayerState, z0),
    MEMBER(layerState, LayerState, z1),
    MEMBER(layerState, LayerState, flags),
    MEMBER(layerState, LayerState, batch),
    MEMBER(areaInstance, AreaInstance, origin),
    MEMBER(areaInstance, AreaInstance, cosSin),
    MEMBER(areaInstance, AreaInstance, shape),
    MEMBER(areaInstance, AreaInstance, layer),
    MEMBER(areaInstance, AreaInstance, element),
    MEMBER(areaInstance, AreaInstance, isMirrored),
    MEMBER(areaInstance, AreaInstance, height),
    MEMBER(areaInstance, AreaInstance, onlyAs),
    MEMBER(areaInstance, AreaInstance, floor),
    MEMBER(areaInstance, AreaInstance, material),
    MEMBER(shapeBound, ShapeBound, centre),
    MEMBER(shapeBound, ShapeBound, extent),
    MEMBER(shapeBound, ShapeBound, stray),
    MEMBER(drawIndexed, DrawIndexed, indexCount),
    MEMBER(drawIndexed, DrawIndexed, instanceCount),
    MEMBER(drawIndexed, DrawIndexed, firstIndex),
    MEMBER(drawIndexed, DrawIndexed, vertexOffset),
    MEMBER(drawIndexed, DrawIndexed, firstInstance),
    MEMBER(draw, Draw, vertexCount),
    MEMBER(draw, Draw, instanceCount),
    MEMBER(draw, Draw, firstVertex),
    MEMBER(draw, Draw, firstInstance),
    MEMBER(areaDraw, AreaDraw, indexCount),
    MEMBER(areaDraw, AreaDraw, firstIndex),
    MEMBER(areaDraw, AreaDraw, vertexOffset),
    MEMBER(areaDraw, AreaDraw, wallVertexCount),
    MEMBER(areaDraw, AreaDraw, firstWallVertex),
    MEMBER(areaDraw, AreaDraw, firstInstance),
    MEMBER(areaRun, AreaRun, first),
    MEMBER(areaRun, AreaRun, count),
    MEMBER(frameData, FrameData, clipFromBoard),
    MEMBER(frameData, FrameData, planes),
    MEMBER(frameData, FrameData, eye),
    MEMBER(frameData, FrameData, centre),
    MEMBER(frameData, FrameData, screen),
    MEMBER(frameData, FrameData, screenRight),
    MEMBER(frameData, FrameData, screenDown),
    MEMBER(frameData, FrameData, width),
    MEMBER(frameData, FrameData, height),
    MEMBER(frameData, FrameData, light),
    MEMBER(frameData, FrameData, pixelsPerMm),
    MEMBER(frameData, FrameData, tolerancePx),
    MEMBER(frameData, FrameData, quadRadiusPx),
    MEMBER(frameData, FrameData, rasterRadiusPx),
    MEMBER(frameData, FrameData, thinPx),
    MEMBER(frameData, FrameData, nudgeZ),
    MEMBER(frameData, FrameData, sectionPlane),
    MEMBER(frameData, FrameData, restStrength),
    MEMBER(frameData, FrameData, nudgeW),
    MEMBER(frameData, FrameData, sliverNudge),
    MEMBER(frameData, FrameData, boreProtrusionMm),
    MEMBER(frameData, FrameData, flags),
    MEMBER(frameData, FrameData, firstTriangle),
    MEMBER(frameData, FrameData, triangleCount),
    MEMBER(frameData, FrameData, quadFace),
    MEMBER(frameData, FrameData, clusterCount),
    MEMBER(frameData, FrameData, letDrawCount),
    MEMBER(frameData, FrameData, instanceCount),
    MEMBER(frameData, FrameData, maxDispatch),
    MEMBER(frameData, FrameData, background),
    MEMBER(frameData, FrameData, layers),
    MEMBER(frameData, FrameData, lets),
    MEMBER(frameData, FrameData, clusters),
    MEMBER(frameData, FrameData, visibleClusters),
    MEMBER(frameData, FrameData, letSlots),
    MEMBER(frameData, FrameData, visibleLets),
    MEMBER(frameData, FrameData, letDraws),
    MEMBER(frameData, FrameData, vertices),
    MEMBER(frameData, FrameData, next),
    MEMBER(frameData, FrameData, instances),
    MEMBER(frameData, FrameData, areaDraws),
    MEMBER(frameData, FrameData, areaRuns),
    MEMBER(frameData, FrameData, drawOfInstance),
    MEMBER(frameData, FrameData, bounds),
    MEMBER(frameData, FrameData, areaCounts),
    MEMBER(frameData, FrameData, visibleInstances),
    MEMBER(frameData, FrameData, visiblePatches),
    MEMBER(frameData, FrameData, patchDraws),
    MEMBER(frameData, FrameData, commandCounts),
    MEMBER(frameData, FrameData, capDraws),
    MEMBER(frameData, FrameData, wallDraws),
    MEMBER(frameData, FrameData, elementStates),
    MEMBER(frameData, FrameData, palette),
    MEMBER(frameData, FrameData, standardParts),
    MEMBER(frameData, FrameData, keyLight),
    MEMBER(frameData, FrameData, reserved),
    MEMBER(shadows, Shadows, cells),
    MEMBER(shadows, Shadows, origin),
    MEMBER(shadows, Shadows, cellsPerMm),
    MEMBER(shadows, Shadows, strength),
    MEMBER(shadows, Shadows, width),
    MEMBER(shadows, Shadows, height),
    MEMBER(standardVertex, StandardVertex, x),
    MEMBER(standardVertex, StandardVertex, y),
    MEMBER(standardVertex, StandardVertex, face),
    MEMBER(standardVertex, StandardVertex, owner),
    MEMBER(standardPart, StandardPartRecord, vertices),
    MEMBER(standardPart, StandardPartRecord, layer),
    MEMBER(standardPart, StandardPartRecord, reserved),
    MEMBER(cutTrapezoid, SectionTrapezoid, colour),
    MEMBER(cutTrapezoid, SectionTrapezoid, rank),
    MEMBER(cutTrapezoid, SectionTrapezoid, from),
    MEMBER(cutTrapezoid, SectionTrapezoid, to),
    MEMBER(cutTrapezoid, SectionTrapezoid, upperFrom),
    MEMBER(cutTrapezoid, SectionTrapezoid, upperTo),
    MEMBER(cutTrapezoid, SectionTrapezoid, bottom),
    MEMBER(cutTrapezoid, SectionTrapezoid, top),
    MEMBER(rasterCopy, RasterCopy, frame),
    MEMBER(rasterCopy, RasterCopy, firstId),
    MEMBER(rasterCopy, RasterCopy, reserved),
    MEMBER(rasterPush, RasterPush, pixels),
    MEMBER(rasterPush, RasterPush, copies),
    MEMBER(rasterPush, RasterPush, copy),
    MEMBER(rasterPush, RasterPush, copyCount),
    MEMBER(pushStruct, Push, frame),
    MEMBER(pushStruct, Push, first),
    MEMBER(pushStruct, Push, face),
#undef MEMBER
};

}  // namespace

/// C++ and GLSL agree on every struct that crosses; the compiled shaders are valid.
class ShaderLayoutTest : public QObject {
    Q_OBJECT

    /// "struct.member" -> place, as glslangValidator sees it.
    static QMap<QString, Location> reflect() {
        QProcess compiler;
        compiler.start(COPPERSCOPE_GLSLANG, {"-q", "-l", "-S", "comp", "--target-env", "vulkan1.3", "-o",
                                             QProcess::nullDevice(), COPPERSCOPE_LAYOUT_SHADER});
        compiler.waitForFinished();
        const QString output = QString::fromUtf8(compiler.readAllStandardOutput());
        static const QRegularExpression line(R"(^(\w+\.\w+): offset (\d+),.*topLevelArrayStride (\d+)$)",
                                             QRegularExpression::MultilineOption);
        QMap<QString, Location> locations;
        for (auto matches = line.globalMatch(output); matches.hasNext();) {
            const QRegularExpressionMatch match = matches.next();
            locations[match.captured(1)] = {match.captured(2).toULongLong(), match.captured(3).toULongLong()};
        }
        return locations;
    }

private slots:
    void everyMemberLiesAtTheSamePlaceInBothLanguages() {
        const QMap<QString, Location> glsl = reflect();
        QVERIFY(!glsl.isEmpty());
        QCOMPARE(glsl.keys(), kCompiled.keys());
        for (const QString& member : glsl.keys()) {
            QVERIFY2(glsl[member] == kCompiled[member], qPrintable(member));
        }
    }

    void compiledShadersAreValid_data() {
        QTest::addColumn<QByteArray>("code");
        const auto addRow = [](const char* name, shader::spirv::Code code) {
            QTest::newRow(name) << QByteArray(reinterpret_cast<const char*>(code.data()),
                                              static_cast<qsizetype>(code.size_bytes()));
        };
#define ADD_ROW(name, words) addRow(#words, shader::spirv::name);
        COPPERSCOPE_SHADERS(ADD_ROW)
#undef ADD_ROW
    }
    void compiledShadersAreValid() {
        const QString validator = QStandardPaths::findExecutable("spirv-val");
        if (validator.isEmpty()) {
            QSKIP("spirv-val is not installed");
        }
        QFETCH(QByteArray, code);
        QTemporaryDir folder;
        QFile file(folder.filePath("shader.spv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(code), code.size());
        file.close();
        QProcess process;
        process.start(validator, {"--target-env", "vulkan1.3", "--scalar-block-layout", file.fileName()});
        QVERIFY(process.waitForFinished());
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
    }
};

QTEST_APPLESS_MAIN(ShaderLayoutTest)
#include "shader_layout_test.moc"
