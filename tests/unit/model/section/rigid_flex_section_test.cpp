// Sections of a rigid-flex board: what is in which zone, and at which height.
#include <QtTest>
#include <map>

#include "model/export/section_export.h"
#include "model/section/section.h"
#include "tests/unit/model/formats/odb/odb_testing.h"
#include "tests/unit/model/hand_made.h"

using namespace model;
using namespace odb_testing;
using hand_made::indexed;
using hand_made::kMm;

namespace {

/// Along the middle of the board: 40 mm rigid, 40 mm flexible, 20 mm with a stiffener.
Section cut(const std::shared_ptr<const Document>& board, double y = 10e6, bool isAsSolid = false) {
    return *makeSection(*indexed(board), {{{0.0, y}, {100e6, y}}, {}, isAsSolid});
}

/// "from-to" in mm and "@bottom-top" in µm from a height, of a material.
QStringList textOf(const Section& section, SectionMaterial material, Nm from = 0) {
    QStringList list;
    for (const SectionPiece& piece : merged(section.pieces)) {
        if (piece.material == material) {
            list << QString("%1-%2@%3-%4")
                        .arg(piece.from / 1e6)
                        .arg(piece.to / 1e6)
                        .arg(double(piece.bottom - from) / 1000)
                        .arg(double(piece.top - from) / 1000);
        }
    }
    list.sort();
    return list;
}

}  // namespace

class RigidFlexSectionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_board = read(dataJob("rigid_flex")); }

    /// Pads of 1 mm at x = 60 mm on the flexible copper, which is 35 µm thick; coverlay 50 µm.
    void coverlayIsLevelAndFillsTheSpaceBesideFlexibleCopper() {
        const Nm face = layerOf(*m_board, "l2").z;
        QCOMPARE(textOf(cut(m_board), SectionMaterial::Coverlay, face),
                 (QStringList{"40-59.5@0-85", "59.5-60.5@35-85", "60.5-100@0-85"}));
    }

    void stiffenersLieUnderTheLayersThatTheirZoneHas() {
        const Section section = cut(m_board);
        const Nm face = layerOf(*m_board, "l3").z;
        QVERIFY(face > layerOf(*m_board, "bot").z);
        QCOMPARE(textOf(section, SectionMaterial::Adhesive, face), QStringList{"80-100@-50-35"});
        QCOMPARE(textOf(section, SectionMaterial::Stiffener, face), QStringList{"80-100@-250--50"});
    }

    void whatIsAssumedOfFilmsIsSaid() {
        const std::vector<std::string> notes = cut(m_board).notes;
        const std::string all = notes.empty() ? "" : notes.back();
        QVERIFY2(all.find("coverlay and adhesive fill the space beside copper") != all.npos, all.c_str());
        QVERIFY2(all.find("draws nothing of them: COVER, GLUE, PLATE") != all.npos, all.c_str());
        QVERIFY(notes.front().find("GLUE") != std::string::npos);  // its thickness too
    }

    void resinIsOnlyWherePrepregIs() {
        auto board = std::make_shared<Document>(*m_board);
        for (StackupRow& row : board->stackup.rows) {
            if (row.name.starts_with("PREPREG")) {
                row.material.type = "PREPREG";
            }
        }
        const Section section = cut(board);
        const Layer& l2 = layerOf(*board, "l2");
        const Layer& l3 = layerOf(*board, "l3");
        const Layer& core = layerOf(*board, "core");
        QCOMPARE(textOf(section, SectionMaterial::Polyimide),
                 QStringList{QString("0-100@%1-%2").arg(core.z / 1000.0).arg((core.z + core.thickness) / 1000.0)});
        // In the rigid part prepreg from the outer copper to the core, in the flexible part none.
        for (const SectionPiece& piece : section.pieces) {
            if (piece.material == SectionMaterial::Prepreg) {
                QVERIFY(piece.to <= 40e6 + 1.0);
            }
        }
        const auto isPrepregAt = [&](Nm z) {
            return std::ranges::any_of(section.pieces, [&](const SectionPiece& piece) {
                return piece.material == SectionMaterial::Prepreg && piece.bottom <= z && z <= piece.top;
            });
        };
        QVERIFY(isPrepregAt(l2.z + l2.thickness / 2));
        QVERIFY(isPrepregAt(l3.z + l3.thickness / 2));
    }

    /// The 3D view draws every layer at one height, and of films nothing that is not drawn.
    void asSolidNothingMoves() {
        const Section section = cut(m_board, 10e6, true);
        QVERIFY(textOf(section, SectionMaterial::Stiffener).isEmpty());
        const Layer& l2 = layerOf(*m_board, "l2");
        const auto isFilledBeside = [&](const SectionPiece& piece, double at) {
            return isDielectric(piece.material) && piece.from <= at && piece.to >= at && piece.bottom <= l2.z &&
                   piece.top >= l2.z + l2.thickness;
        };
        QVERIFY(std::ranges::any_of(section.pieces, [&](const SectionPiece& p) { return isFilledBeside(p, 15e6); }));
        // The outermost copper of the flexible part lies on the substrate.
        QVERIFY(std::ranges::none_of(section.pieces, [&](const SectionPiece& p) { return isFilledBeside(p, 50e6); }));
    }

    /// A hole through all layers has no wall where the board is thinner.
    void platingReachesAsFarAsTheBoard() {
        Folder folder;
        folder.copyJob("rigid_flex");
        folder.write("steps/board/layers/through/features", "UNITS=MM\n$0 r300\nP 20 10 0 P 0 0\nP 60 10 0 P 0 0\n");
        const auto board = read(folder.path());
        const Section section = cut(board);
        const Layer& l2 = layerOf(*board, "l2");
        const Layer& top = layerOf(*board, "top");
        Nm rigid = 0;
        Nm flexible = 0;
        for (const SectionPiece& piece : section.pieces) {
            if (piece.material == SectionMaterial::Plating) {
                Nm& highest = piece.from < 40e6 ? rigid : flexible;
                highest = std::max(highest, piece.top);
            }
        }
        QCOMPARE(rigid, top.z + top.thickness);
        QCOMPARE(flexible, l2.z + l2.thickness);
    }

    /// On coverlay in the flexible part, on the outer copper's mask in the rigid one.
    void partsStandOnWhatTheirZoneHas() {
        Folder folder;
        folder.copyJob("rigid_flex");
        folder.write("matrix/matrix", readFile(folder.path() / "matrix/matrix") +
                                          "LAYER {\n ROW=13\n CONTEXT=BOARD\n TYPE=COMPONENT\n NAME=COMP_+_TOP\n}\n");
        folder.write("steps/board/eda/data",
                     "UNITS=MM\nPKG BOX 4 -2 -2 2 2\nPIN 1 S -1.5 0 0 E S\nPIN 2 S 1.5 0 0 E S\n");
        folder.write(
            "steps/board/layers/comp_+_top/components",
            "UNITS=MM\n@0 .comp_height\nCMP 0 20 10 0 N U1 BOX ;0=1\nTOP 0 18.5 10 0 N -1 0\nTOP 1 21.5 10 0 N "
            "-1 0\nCMP 0 70 10 0 N U2 BOX ;0=1\nTOP 0 68.5 10 0 N -1 0\nTOP 1 71.5 10 0 N -1 0\n");
        const auto board = read(folder.path());
        QCOMPARE(board->bodies.size(), std::size_t{2});
        std::map<bool, Nm> lowest{{false, 1000 * kMm}, {true, 1000 * kMm}};
        for (const SectionPiece& piece : cut(board).pieces) {
            if (piece.material == SectionMaterial::Part || piece.material == SectionMaterial::Terminal) {
                Nm& own = lowest[piece.from > 40e6];
                own = std::min(own, piece.bottom);
            }
        }
        const Layer& cover = layerOf(*board, "cover");
        QCOMPARE(lowest[true], cover.z + cover.thickness);
        const Layer& top = layerOf(*board, "top");
        QVERIFY(lowest[false] >= top.z + top.thickness);
        // And so do bodies in 3D, on the plate of the mask.
        const auto bottomOf = [&](std::size_t component) {
            const auto body = std::ranges::find(board->bodies, ComponentId{component}, &Body::component);
            return board->heightsOf(body->element).bottom;
        };
        QCOMPARE(bottomOf(1), cover.z + cover.thickness);
        const Layer& mask = layerOf(*board, "smt");
        QCOMPARE(bottomOf(0), mask.z + mask.thickness);
    }

    /// What a job draws of a stiffener is where it is, on what its zone has.
    void drawnStiffenersAreWhereTheyAreDrawn() {
        Folder folder;
        folder.copyJob("rigid_flex");
        folder.write("steps/board/layers/plate/features", "UNITS=MM\n$0 rect10000x10000\nP 90 10 0 P 0 0\n");
        const auto board = read(folder.path());
        const Nm face = layerOf(*board, "l3").z;
        QCOMPARE(textOf(cut(board), SectionMaterial::Stiffener, face), QStringList{"85-95@-250--50"});
        QVERIFY(hasSubstance(layerOf(*board, "plate")));
        const std::string notes = cut(board).notes.back();
        QVERIFY2(notes.find("draws nothing of them: COVER, GLUE;") != notes.npos ||
                     notes.ends_with("draws nothing of them: COVER, GLUE"),
                 notes.c_str());
    }

    /// Flipped on a panel, the stiffener lies on the upper side.
    void zonesComeWithTheirSteps() {
        Folder folder;
        folder.copyJob("rigid_flex");
        fs::rename(folder.path() / "steps/board", folder.path() / "steps/card");
        folder.write("steps/panel/stephdr",
                     "STEP-REPEAT {\nNAME=card\nX=10\nY=10\nDX=0\nDY=0\nNX=1\nNY=1\nANGLE=0\n}\n"
                     "UNITS=MM\n");
        folder.write("steps/panel/profile",
                     "UNITS=MM\nS P 0\nOB 0 0 I\nOS 0 50\nOS 200 50\nOS 200 0\nOS 0 0\nOE\nSE\n");
        const auto panel = read(folder.path(), "panel");
        const Section section = *makeSection(*indexed(panel), {{{0.0, 20e6}, {200e6, 20e6}}, {}});
        QCOMPARE(textOf(section, SectionMaterial::Stiffener, layerOf(*panel, "l3").z), QStringList{"90-110@-250--50"});
    }

    void exportsTellFilmsThatAreNotDrawn() {
        const auto index = indexed(m_board);
        const Section section = cut(m_board);
        const std::string csv = sectionCsv(*index, section);
        QVERIFY2(csv.find("solid,PLATE,0,,,80000000.000,") != std::string::npos, csv.c_str());
        SectionPicture how{std::vector<std::uint32_t>(m_board->layers.size(), 0x123456)};
        const std::string svg = sectionSvg(*m_board, section, how);
        for (const char* name : {">coverlay<", ">adhesive<", ">stiffener<"}) {
            QVERIFY2(svg.find(name) != std::string::npos, name);
        }
    }

private:
    std::shared_ptr<const Document> m_board;
};

QTEST_APPLESS_MAIN(RigidFlexSectionTest)
#include "rigid_flex_section_test.moc"
