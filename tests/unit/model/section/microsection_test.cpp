// What a section shows beyond what layers draw: where laser vias end, what dielectrics are, where parts stand.
#include <QtTest>
#include <random>

#include "model/board/document_builder.h"
#include "model/export/section_export.h"
#include "model/formats/registry.h"
#include "model/section/section.h"
#include "tests/locations.h"
#include "tests/unit/model/hand_made.h"

using namespace model;
using namespace hand_made;

namespace {

/// Three copper layers of 20 µm with 80 µm of prepreg above and 100 µm of core below the inner one, solder mask, and a
/// laser via of 100 µm, plated 15 µm, from the top to the inner layer; the substrate is cut as the drill passes it.
enum BoardLayer : std::size_t { Top, Inner, Bottom, Laser, Upper, Lower, Openings, Mask };

StackupRow row(const char* type, Nm z, Nm thickness) {
    StackupRow row;
    row.name = type;
    row.z = z;
    row.thickness = thickness;
    row.material.type = type;
    return row;
}

ShapeSketch plate() {
    return rectangle({-kMm, -kMm}, {kMm, kMm});
}

void addLayers(DocumentBuilder& builder) {
    hand_made::addLayers(builder,
                         std::array{StackLayer{"top", LayerType::Signal, 220'000, 20'000, Top},
                                    StackLayer{"inner", LayerType::Signal, 120'000, 20'000, Inner},
                                    StackLayer{"bottom", LayerType::Signal, 0, 20'000, Bottom},
                                    StackLayer{"laser", LayerType::Drill, 120'000, 120'000, Laser},
                                    StackLayer{"board 1", LayerType::Body, 120'000, 100'000, Upper},
                                    StackLayer{"board 2", LayerType::Body, 20'000, 100'000, Lower},
                                    StackLayer{"mask", LayerType::SolderMask, 240'000, 30'000, Openings},
                                    StackLayer{"mask solder mask", LayerType::SolderMask, 240'000, 30'000, Mask}});
    builder.layer(LayerId{Laser}).spanBottom = LayerId{Inner};
    builder.layer(LayerId{Top}).side = builder.layer(LayerId{Mask}).side = LayerSide::Top;
    builder.layer(LayerId{Inner}).side = LayerSide::Inner;
    builder.layer(LayerId{Bottom}).side = LayerSide::Bottom;
    builder.layer(LayerId{Mask}).isSynthetic = true;
    builder.layer(LayerId{Mask}).openings = LayerId{Openings};
}

std::shared_ptr<const Document> board() {
    DocumentBuilder builder;
    addLayers(builder);
    for (const std::size_t copper : {Top, Inner}) {
        builder.beginLayer(LayerId{copper});
        builder.addCircle({{0, 0}, 300'000, 0}, {});
    }
    builder.beginLayer(LayerId{Laser});
    builder.addCircle({{0, 0}, 100'000, 70'000}, flagged(kHole | kPlated | kVia));
    builder.beginLayer(LayerId{Upper});
    ShapeSketch drilled = plate();
    drilled.addCircle({0, 0}, 50'000, true);
    builder.addArea({builder.addShape(drilled), {}}, {});
    builder.beginLayer(LayerId{Lower});
    builder.addArea({builder.addShape(plate()), {}}, {});
    builder.beginLayer(LayerId{Mask});
    builder.addArea({builder.addShape(plate()), {}}, {});
    Stackup stackup;
    stackup.rows = {row("PREPREG", 140'000, 80'000), row("CORE", 20'000, 100'000)};
    builder.setStackup(stackup);
    return builder.finish();
}

Section cut(double y = 0.0) {
    return *makeSection(*indexed(board()), {{{-2e6, y}, {2e6, y}}, {}});
}

/// "material lower edge/upper edge@heights", lengths from the axis of the via in micrometres.
QStringList textOf(const Section& section, SectionMaterial material) {
    QStringList list;
    for (const SectionPiece& piece : merged(section.pieces)) {
        if (piece.material == material) {
            list << QString("%1..%2/%3..%4@%5-%6")
                        .arg(std::lround((piece.from - 2e6) / 1000))
                        .arg(std::lround((piece.to - 2e6) / 1000))
                        .arg(std::lround((piece.upperFrom() - 2e6) / 1000))
                        .arg(std::lround((piece.upperTo() - 2e6) / 1000))
                        .arg(piece.bottom / 1000)
                        .arg(piece.top / 1000);
        }
    }
    list.sort();
    return list;
}

bool overlaps(const SectionPiece& a, const SectionPiece& b) {
    constexpr double kRounding = 2.0;
    return a.from < b.to - kRounding && b.from < a.to - kRounding && a.bottom < b.top && b.bottom < a.top;
}

}  // namespace

class MicrosectionTest : public QObject {
    Q_OBJECT

private slots:
    void aLaserViaEndsOnItsTargetPadAndIsPlatedThere() {
        const Section section = cut();
        QCOMPARE(
            textOf(section, SectionMaterial::Copper),
            (QStringList{"-150..-50/-150..-50@220-240", "-150..150/-150..150@120-140", "50..150/50..150@220-240"}));
        QCOMPARE(textOf(section, SectionMaterial::Plating),
                 (QStringList{"-40..40/-42..42@140-155", "-42..-27/-50..-35@155-220", "-50..-35/-50..-35@220-240",
                              "27..42/35..50@155-220", "35..50/35..50@220-240"}));
        QCOMPARE(section.bores.size(), std::size_t{1});
        QCOMPARE(section.bores[0].bottom, Nm{140'000});
        QVERIFY(section.notes.back().starts_with("assumed: ") || section.notes.size() > 2);
    }

    void dielectricsAreWhatTheStackupCallsThem() {
        const Section section = cut();
        // Prepreg lies beside inner copper, and beside what the laser left.
        QCOMPARE(textOf(section, SectionMaterial::Core), (QStringList{"-1000..1000/-1000..1000@20-120"}));
        QCOMPARE(textOf(section, SectionMaterial::Prepreg),
                 (QStringList{"-1000..-150/-1000..-150@120-220", "-150..-50/-150..-50@140-220",
                              "-50..-40/-50..-42@140-155", "-50..-42/-50..-50@155-220", "150..1000/150..1000@120-220",
                              "40..50/42..50@140-155", "42..50/50..50@155-220", "50..150/50..150@140-220"}));
        QVERIFY(textOf(section, SectionMaterial::Dielectric).empty());
    }

    void dielectricsAreOfTheirRowOfTheStackup() {
        const auto of = board();
        const Section section = cut();
        int told = 0;
        for (const SectionPiece& piece : section.pieces) {
            const StackupRow* row = stackupRowOf(*of, piece);
            QCOMPARE(row != nullptr, isDielectric(piece.material));
            if (row != nullptr) {
                QCOMPARE(row->material.type, piece.material == SectionMaterial::Core ? "CORE" : "PREPREG");
                ++told;
            }
        }
        QVERIFY(told > 5);
        const QString csv = QString::fromStdString(sectionCsv(*indexed(of), section));
        QVERIFY(csv.contains(",prepreg,PREPREG,80000\r\n") && csv.contains(",core,CORE,100000\r\n"));
        QVERIFY(csv.contains(",copper,,\r\n"));
    }

    /// Also where only the substrate is asked for.
    void copperThatIsNotShownIsTakenOutOfDielectricsToo() {
        std::vector<bool> layers(8, false);
        layers[Upper] = layers[Lower] = true;
        const Section section = *makeSection(*indexed(board()), {{{-2e6, 0}, {2e6, 0}}, layers});
        QVERIFY(textOf(section, SectionMaterial::Copper).empty());
        QVERIFY(textOf(section, SectionMaterial::Prepreg).contains("50..150/50..150@140-220"));
        QVERIFY(textOf(section, SectionMaterial::Prepreg).contains("150..1000/150..1000@120-220"));
    }

    void copperAndDielectricsNeverFillTheSameHeight() {
        base::Progress progress;
        const auto sample = *readBoard(locations::kSample, {}, progress);
        const auto index = indexed(sample);
        int inner = 0;
        for (int i = 1; i < 20; ++i) {
            const double y = sample->board.min.y + i / 20.0 * (double{1} * sample->board.max.y - sample->board.min.y);
            const Section section =
                *makeSection(*index, {{{double(sample->board.min.x), y}, {double(sample->board.max.x), y}}, {}});
            for (const SectionPiece& copper : section.pieces) {
                if (copper.material != SectionMaterial::Copper) {
                    continue;
                }
                inner += sample->layer(copper.layer).side == LayerSide::Inner ? 1 : 0;
                QVERIFY(std::ranges::none_of(section.pieces, [&](const SectionPiece& other) {
                    return isDielectric(other.material) && overlaps(copper, other);
                }));
            }
        }
        QVERIFY2(inner > 50, qPrintable(QString::number(inner)));
    }

    void resinIsOfTheDielectricThatFlows() {
        const auto bandsOf = [](const char* upper, const char* lower, const std::vector<bool>& has) {
            auto own = std::make_shared<Document>(*board());
            own->stackup.rows = {row(upper, 140'000, 80'000), row(lower, 20'000, 100'000)};
            QStringList list;
            for (const DielectricBand& band : dielectricBandsOf(*own, has)) {
                list << QString("%1 %2-%3").arg(toString(band.material)).arg(band.bottom / 1000).arg(band.top / 1000);
            }
            return list;
        };
        QCOMPARE(bandsOf("CORE", "PREPREG", {true, true}), (QStringList{"core 140-220", "prepreg 20-140"}));
        QCOMPARE(bandsOf("PREPREG", "CORE", {true, true}), (QStringList{"prepreg 120-220", "core 20-120"}));
        QCOMPARE(bandsOf("CORE", "", {true, true}),
                 (QStringList{"core 140-220", "dielectric, type not stated 20-140"}));
        QCOMPARE(bandsOf("CORE", "PREPREG", {true, false}), QStringList{"core 140-220"});
    }

    void maskFlowsOverPadsAndTentsVias() {
        QCOMPARE(
            textOf(cut(), SectionMaterial::SolderMask),
            (QStringList{"-1000..-150/-1000..-150@220-250", "-150..150/-150..150@240-255",
                         "-180..-150/-150..-150@250-255", "150..1000/150..1000@220-250", "150..180/150..150@250-255"}));
    }

    void asSolidViasTaperAndMaskIsLevel() {
        const Section section = *makeSection(*indexed(board()), {{{-2e6, 0}, {2e6, 0}}, {}, true});
        QCOMPARE(textOf(section, SectionMaterial::Plating), textOf(cut(), SectionMaterial::Plating));
        QCOMPARE(textOf(section, SectionMaterial::SolderMask),
                 (QStringList{"-1000..-150/-1000..-150@220-270", "-150..150/-150..150@240-270",
                              "150..1000/150..1000@220-270"}));
    }

    void aLineThatEndsInTheViaCutsItThere() {
        const Section section = *makeSection(*indexed(board()), {{{-2e6, 0}, {0, 0}, {0, 2e6}}, {}});
        QStringList plating = textOf(cut(), SectionMaterial::Plating);
        plating[0] = "-40..0/-42..0@140-155";
        plating.insert(3, "0..40/0..42@140-155");
        QCOMPARE(textOf(section, SectionMaterial::Plating), plating);
    }

    void assumptionsAreNamed() {
        const std::vector<std::string> notes = cut().notes;
        const auto isNamed = [&](const char* word) {
            return std::ranges::any_of(
                notes, [&](const std::string& n) { return n.starts_with("assumed") && n.find(word) != n.npos; });
        };
        QVERIFY(isNamed("50 % as thick on copper"));
        QVERIFY(isNamed("narrow to 80 %"));
        QVERIFY(isNamed("include surface plating"));
        QVERIFY(isNamed("dielectrics fill the space beside inner copper"));
        QVERIFY(!isNamed("parts"));
    }

    /// On a real board: nothing of a part lies in the mask, print, paste or solder, and solder is between pad and part.
    void partsStandOnTheBoard() {
        base::Progress progress;
        const auto sample = *readBoard(locations::kSample, {}, progress);
        const auto index = indexed(sample);
        int parts = 0;
        int joints = 0;
        for (int i = 1; i < 40; ++i) {
            const double y = sample->board.min.y + i / 40.0 * (double{1} * sample->board.max.y - sample->board.min.y);
            const Section section =
                *makeSection(*index, {{{double(sample->board.min.x), y}, {double(sample->board.max.x), y}}, {}});
            for (const SectionPiece& part : section.pieces) {
                const bool isPart =
                    part.material == SectionMaterial::Part || part.material == SectionMaterial::Terminal;
                const bool isPin = part.bottom < sample->boardThickness && part.top > 0 && isPart;
                if (part.material == SectionMaterial::Solder) {
                    ++joints;
                }
                if (!isPart || isPin) {
                    continue;
                }
                ++parts;
                for (const SectionPiece& other : section.pieces) {
                    const bool isBoard = drawOrderOf(other.material) == 3;
                    QVERIFY2(!isBoard || !overlaps(part, other),
                             qPrintable(QString("%1 over %2: %3-%4 and %5-%6")
                                            .arg(toString(part.material), toString(other.material))
                                            .arg(part.bottom)
                                            .arg(part.top)
                                            .arg(other.bottom)
                                            .arg(other.top)));
                }
            }
        }
        QVERIFY2(parts > 20 && joints > 5, qPrintable(QString("%1 %2").arg(parts).arg(joints)));
    }
};

QTEST_APPLESS_MAIN(MicrosectionTest)
#include "microsection_test.moc"
