// One board written in several forms by one program: the forms must agree. Boards as formats/README.md has them.
//
// What is plotted as Gerber is what is made, so layers, outlines and holes are compared with that; parts, pins and nets
// with KiCad's own file, which all others were written from. Where a form differs it is its writer that draws something
// else: what, and how much of it, is listed with its reason, and the test fails too once that is no longer so.
#include <QtTest>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include "model/agreement/agreement.h"
#include "model/base/ascii.h"
#include "model/formats/registry.h"
#include "model/text/formatting.h"
#include "tests/locations.h"

using model::Aspect;
using model::Comparison;

namespace {

namespace fs = std::filesystem;

// ---- what writers are known to do ----
//
// Each reason is proved by records of the writer's own: file and line, unpacked, of the board's folder.

/// StickHub-ipc2581c.xml:19608, 25985 and 33470 lay one shape of R1's pin 1 on B.Cu, B.Mask and B.Paste; so they do
/// with every pad of a pin on all seven boards. custom_pads_test.kicad_pcb:1127 asks for a margin of 0.5 mm,
/// RoyalBlue54L-Feather.kicad_pcb:4477 for no mask over a pad that -ipc2581c.xml:59471 opens,
/// multichannel_mixer-F_Paste.gtp draws nothing where -ipc2581c.xml:41135 has 135 pads of holes.
constexpr const char* kPadsOnMaskAndPaste =
    "KiCad's IPC-2581 repeats every pad of a pin on the mask and paste of the sides it has copper on, without margins";
/// The hole of J1's pin 5 is at (143.23, -116.41), its pad 0.21 mm towards (143.23, -116.20), where F_Cu.gtl:1325
/// flashes it; RoyalBlue54L-Feather-ipc2581c.xml:25997 has (143.02, -116.41). So do all 27 pads with an offset.
constexpr const char* kOffsetNotTurned =
    "KiCad's IPC-2581 adds the offset between pad and hole without turning it with the pad";
constexpr const char* kOffsetAndHeatPads =
    "as F.Mask, and the heat pads of U2 and U5 on the back, which have no mask, are opened: see kPadsOnMaskAndPaste";
/// StickHub.kicad_pcb:18113 is a circle of radius 0.75 mm drawn 0.15 mm wide; the symbol of
/// odb/steps/pcb/layers/b.mask/features:11 is donut_r1650.0x1425.0, which is 0.1125 mm wide. So are all circles.
constexpr const char* kNarrowRings =
    "KiCad's ODB++ writes circles as donuts whose inner diameter lacks half a line width: 2r - w/2 for 2r - w";
/// StickHub.kicad_pcb:32350 is a square filled and outlined 0.2 mm wide, 0.1 mm beyond (158, 94.75) as in
/// F_Mask.gts:52; odb/steps/pcb/layers/f.mask/features:33 begins a surface that reaches 0.105 mm beyond it, and line 91
/// draws its outline with r200 once more.
constexpr const char* kOutlinedTwice =
    "KiCad's ODB++ writes filled polygons with the width of their outline twice: grown by it, then outlined again";
/// RoyalBlue54L-Feather.kicad_pcb:21589 keeps "SCL" drawn in Ubuntu Sans, its S 0.48 mm wide; F_Silkscreen.gto:522 and
/// the other forms have an S of 0.56 mm there. 72 texts are of that font.
constexpr const char* kOtherFont =
    "the file keeps its texts drawn in their font; all other forms were written with letters of another one";

/// RoyalBlue54L-Feather-ipc2581c.xml has nine parts J2_1, C9_1 … whose names are also names of balls of U1, and for the
/// part J4 the ball is called J4_1 (21679); microwave has four parts POLY.
constexpr const char* kUniqueNames =
    "KiCad's writers give no name twice, not even to a part and the pin of another: J3 becomes J3_1, POLY POLY_1";
constexpr const char* kLettersOfRevisionB = "revision B allows few characters in names; the others become _";

/// A layer that a form draws otherwise than the Gerber job.
struct OtherLayer {
    const char* board;
    const char* form;   ///< beginning of its ending: "-ipc2581" are both revisions
    const char* layer;  ///< as comparableName has it
    double missing;     ///< what the form lacks, and what it has besides, in mm² once a pixel is taken away all around
    double extra;
    const char* why;
};

const OtherLayer kOtherLayers[] = {
    {"StickHub", "-odb", "f.mask", 0.0, 3.4716, kOutlinedTwice},
    {"StickHub", "-odb", "b.mask", 0.1750, 0.0, kNarrowRings},
    {"StickHub", "-ipc2581", "f.mask", 2.1332, 0.0, kPadsOnMaskAndPaste},
    {"StickHub", "-ipc2581", "b.mask", 1.0043, 0.0, kPadsOnMaskAndPaste},
    {"StickHub", "-ipc2581", "f.paste", 0.0, 43.2112, kPadsOnMaskAndPaste},
    {"StickHub", "-ipc2581", "b.paste", 0.0, 25.6019, kPadsOnMaskAndPaste},
    {"RoyalBlue54L-Feather", ".kicad_pcb", "f.silkscreen", 11.0073, 3.9816, kOtherFont},
    {"RoyalBlue54L-Feather", ".kicad_pcb", "b.silkscreen", 10.6073, 4.0851, kOtherFont},
    {"RoyalBlue54L-Feather", "-odb", "b.silkscreen", 0.3480, 0.0, kNarrowRings},
    {"RoyalBlue54L-Feather", "-ipc2581", "f.cu", 8.4362, 16.9393, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "in1.cu", 8.4362, 16.9393, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "in2.cu", 8.4248, 17.0493, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "in3.cu", 8.4362, 16.9393, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "in4.cu", 8.4248, 17.0493, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "in5.cu", 8.4362, 17.1593, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "in6.cu", 8.4362, 16.9393, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "b.cu", 8.4362, 16.9943, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "f.mask", 8.5212, 18.4433, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581", "b.mask", 8.5212, 37.4101, kOffsetAndHeatPads},
    {"RoyalBlue54L-Feather", "-ipc2581", "f.paste", 0.0, 159.1526, kPadsOnMaskAndPaste},
    {"RoyalBlue54L-Feather", "-ipc2581", "b.paste", 0.0, 198.0462, kPadsOnMaskAndPaste},
    {"custom_pads_test", "-odb", "f.silkscreen", 1.2895, 0.0, kNarrowRings},
    {"custom_pads_test", "-ipc2581", "f.mask", 66.8582, 0.0, kPadsOnMaskAndPaste},
    {"custom_pads_test", "-ipc2581", "f.paste", 0.0, 582.0748, kPadsOnMaskAndPaste},
    {"custom_pads_test", "-ipc2581", "b.paste", 0.0, 12.9983, kPadsOnMaskAndPaste},
    {"flat_hierarchy", "-odb", "f.silkscreen", 0.7893, 0.0, kNarrowRings},
    {"flat_hierarchy", "-ipc2581", "f.paste", 0.0, 740.2138, kPadsOnMaskAndPaste},
    {"flat_hierarchy", "-ipc2581", "b.paste", 0.0, 740.2138, kPadsOnMaskAndPaste},
    {"kit-dev-coldfire-xilinx_5213", "-odb", "f.silkscreen", 0.5091, 0.0, kNarrowRings},
    {"kit-dev-coldfire-xilinx_5213", "-ipc2581", "f.paste", 0.0, 753.7461, kPadsOnMaskAndPaste},
    {"kit-dev-coldfire-xilinx_5213", "-ipc2581", "b.paste", 0.0, 748.0760, kPadsOnMaskAndPaste},
    {"multichannel_mixer", "-odb", "f.silkscreen", 4.1316, 0.0, kNarrowRings},
    {"multichannel_mixer", "-ipc2581", "f.paste", 0.0, 764.5138, kPadsOnMaskAndPaste},
    {"multichannel_mixer", "-ipc2581", "b.paste", 0.0, 764.5138, kPadsOnMaskAndPaste},
    {"microwave", "-ipc2581", "f.mask", 0.0, 7.1524, kPadsOnMaskAndPaste},
    {"microwave", "-ipc2581", "f.paste", 0.0, 7.1524, kPadsOnMaskAndPaste},
};

/// A list in which a form differs from KiCad's file.
struct OtherList {
    const char* board;
    const char* form;
    Aspect aspect;
    std::size_t differing;  ///< how many differences there are
    const char* why;
};

const OtherList kOtherLists[] = {
    {"RoyalBlue54L-Feather", "-ipc2581", Aspect::Parts, 18, kUniqueNames},
    // 16 pins of J1, J4_1 of U1 (kUniqueNames), and two heat pads drawn once for both sides.
    {"RoyalBlue54L-Feather", "-ipc2581", Aspect::Pins, 19, kOffsetNotTurned},
    {"RoyalBlue54L-Feather", "-ipc2581b", Aspect::NetNames, 64, kLettersOfRevisionB},
    {"StickHub", "-ipc2581b", Aspect::NetNames, 40, kLettersOfRevisionB},
    {"kit-dev-coldfire-xilinx_5213", "-ipc2581b", Aspect::NetNames, 206, kLettersOfRevisionB},
    {"multichannel_mixer", "-ipc2581b", Aspect::NetNames, 76, kLettersOfRevisionB},
    {"flat_hierarchy", "-ipc2581b", Aspect::NetNames, 27, kLettersOfRevisionB},
    {"custom_pads_test", "-ipc2581b", Aspect::NetNames, 2, kLettersOfRevisionB},
    {"custom_pads_test", "-ipc2581b", Aspect::Parts, 2, kLettersOfRevisionB},
    {"microwave", "-odb", Aspect::Parts, 6, kUniqueNames},
    {"microwave", "-ipc2581", Aspect::Parts, 6, kUniqueNames},
};

/// How far the drill files have holes from where KiCad's file has them, at most, in nm: they are written in µm.
struct Rounded {
    const char* board;
    double nm;
};

const Rounded kRoundedDrills[] = {
    {"StickHub", 605.4},      {"RoyalBlue54L-Feather", 652.3}, {"kit-dev-coldfire-xilinx_5213", 622.9},
    {"microwave", 0.0},       {"multichannel_mixer", 2.0},     {"flat_hierarchy", 200.0},
    {"custom_pads_test", 0.0}};

// ---- boards and forms ----

constexpr const char* kBoards[] = {"StickHub",        "RoyalBlue54L-Feather", "kit-dev-coldfire-xilinx_5213",
                                   "microwave",       "multichannel_mixer",   "flat_hierarchy",
                                   "custom_pads_test"};
constexpr const char* kForms[] = {".kicad_pcb", "-odb.tgz", "-ipc2581b.xml", "-ipc2581c.xml"};

/// A form that is packed by itself has .gz behind its ending.
fs::path fileOf(const QString& board, const QString& form) {
    const fs::path plain =
        locations::boards() / "formats" / "kicad" / board.toStdString() / (board + form).toStdString();
    return fs::exists(plain) ? plain : fs::path(plain.string() + ".gz");
}

std::shared_ptr<const model::Document> read(const fs::path& path) {
    base::Progress progress;
    const auto board = model::readBoard(path, {}, progress);
    return board ? *board : nullptr;
}

std::vector<Comparison> compare(const model::Document& a, const model::Document& b, std::vector<Aspect> aspects) {
    model::AgreementRequest request;
    request.allowed = 0.001;
    request.aspects = std::move(aspects);
    base::Progress progress;
    const auto agreement = compareBoards(a, b, request, progress);
    return agreement ? agreement->comparisons : std::vector<Comparison>{};
}

/// F.Mask, F_Mask and F.MASK are one layer.
std::string comparableName(const std::string& name) {
    std::string comparable = base::lowerCase(name);
    std::ranges::replace(comparable, '_', '.');
    return comparable;
}

const OtherLayer* knownOther(const QString& board, const QString& form, const std::string& layer) {
    const auto* const found = std::ranges::find_if(kOtherLayers, [&](const OtherLayer& other) {
        return board == other.board && form.startsWith(other.form) && layer == other.layer;
    });
    return found == std::end(kOtherLayers) ? nullptr : found;
}

const OtherList* knownOther(const QString& board, const QString& form, Aspect aspect) {
    const auto* const found = std::ranges::find_if(kOtherLists, [&](const OtherList& other) {
        return board == other.board && form.startsWith(other.form) && aspect == other.aspect;
    });
    return found == std::end(kOtherLists) ? nullptr : found;
}

/// Names of nets as revision B writes them.
std::multiset<std::string> plainNetNames(const model::Document& board) {
    std::multiset<std::string> names;
    for (const model::Net& net : board.nets) {
        std::string name = net.name;
        std::ranges::replace_if(
            name,
            [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.' && c != '+'; },
            '_');
        names.insert(name);
    }
    return names;
}

bool isAbout(double nm2, double mm2) {
    return std::abs(nm2 / 1e12 - mm2) <= 0.001 + 0.005 * mm2;
}

QByteArray textOf(const Comparison& comparison) {
    std::string text = std::string(toString(comparison.aspect)) + " " + comparison.layers[1] + " " + comparison.note;
    for (const model::Difference& difference : comparison.differences) {
        text += "; " + difference.text;
    }
    return QByteArray::fromStdString(text);
}

void addForms(std::initializer_list<const char*> besides) {
    QTest::addColumn<QString>("board");
    QTest::addColumn<QString>("form");
    for (const char* board : kBoards) {
        for (const char* form : kForms) {
            if (std::ranges::find(besides, std::string_view(form)) == besides.end()) {
                QTest::addRow("%s%s", board, form) << board << form;
            }
        }
    }
}

}  // namespace

class OracleTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!fs::exists(locations::boards() / "formats" / "kicad")) {
            QSKIP("the folder of boards holds no formats/kicad");
        }
    }

    void layersAndHolesAreAsPlotted_data() { addForms({}); }
    void layersAndHolesAreAsPlotted() {
        QFETCH(QString, board);
        QFETCH(QString, form);
        const auto plotted = read(fileOf(board, "-gerbers.zip"));
        const auto other = read(fileOf(board, form));
        QVERIFY(plotted != nullptr && other != nullptr);
        const auto comparisons = compare(*plotted, *other,
                                         {Aspect::Copper, Aspect::SolderMask, Aspect::SolderPaste, Aspect::Silkscreen,
                                          Aspect::Outline, Aspect::Holes, Aspect::Nets});
        QVERIFY(comparisons.size() >= 5);
        std::ptrdiff_t known = 0;
        for (const Comparison& comparison : comparisons) {
            const OtherLayer* const as = knownOther(board, form, comparableName(comparison.layers[1]));
            if (as == nullptr) {
                QVERIFY2(comparison.accord != model::Accord::Differ, textOf(comparison).constData());
                continue;
            }
            ++known;
            QVERIFY2(comparison.region.has_value(), textOf(comparison).constData());
            QVERIFY2(isAbout(comparison.region->only[0], as->missing), textOf(comparison).constData());
            QVERIFY2(isAbout(comparison.region->only[1], as->extra), textOf(comparison).constData());
        }
        QCOMPARE(known, std::ranges::count_if(kOtherLayers, [&](const OtherLayer& as) {
                     return board == as.board && form.startsWith(as.form);
                 }));
    }

    void partsAndNetsAreAsInTheSource_data() { addForms({".kicad_pcb"}); }
    void partsAndNetsAreAsInTheSource() {
        QFETCH(QString, board);
        QFETCH(QString, form);
        const auto source = read(fileOf(board, ".kicad_pcb"));
        const auto other = read(fileOf(board, form));
        QVERIFY(source != nullptr && other != nullptr);
        const auto comparisons =
            compare(*source, *other, {Aspect::Parts, Aspect::Pins, Aspect::Nets, Aspect::NetNames});
        QCOMPARE(comparisons.size(), std::size_t{4});
        for (const Comparison& comparison : comparisons) {
            const OtherList* const as = knownOther(board, form, comparison.aspect);
            QVERIFY2(comparison.differing == (as == nullptr ? 0 : as->differing), textOf(comparison).constData());
            QVERIFY2(comparison.note.find("another rotation") == std::string::npos, textOf(comparison).constData());
        }
    }

    /// To the nanometre: these forms are written with six digits behind the millimetre.
    void holesAndPartsLieWhereTheSourceHasThem_data() { addForms({".kicad_pcb"}); }
    void holesAndPartsLieWhereTheSourceHasThem() {
        QFETCH(QString, board);
        QFETCH(QString, form);
        const auto source = read(fileOf(board, ".kicad_pcb"));
        const auto other = read(fileOf(board, form));
        QVERIFY(source != nullptr && other != nullptr);
        const auto comparisons = compare(*source, *other, {Aspect::Holes, Aspect::Parts});
        QCOMPARE(comparisons.size(), std::size_t{2});
        QCOMPARE(comparisons[0].farthest.value_or(0.0), 0.0);
        QCOMPARE(comparisons[0].farthest.has_value(), board != "microwave");  // which has no holes
        QCOMPARE(comparisons[1].farthest, std::optional(0.0));
    }

    void drillsAreRoundedToAMicrometre_data() {
        QTest::addColumn<QString>("board");
        QTest::addColumn<double>("nm");
        for (const Rounded& known : kRoundedDrills) {
            QTest::newRow(known.board) << QString(known.board) << known.nm;
        }
    }
    void drillsAreRoundedToAMicrometre() {
        QFETCH(QString, board);
        QFETCH(double, nm);
        const auto source = read(fileOf(board, ".kicad_pcb"));
        const auto plotted = read(fileOf(board, "-gerbers.zip"));
        QVERIFY(source != nullptr && plotted != nullptr);
        const auto comparisons = compare(*source, *plotted, {Aspect::Holes});
        QCOMPARE(comparisons.size(), std::size_t{1});
        QVERIFY2(std::abs(comparisons[0].farthest.value_or(0.0) - nm) < 0.1, textOf(comparisons[0]).constData());
        QCOMPARE(comparisons[0].differing, std::size_t{0});
    }

    void revisionBChangesOnlyCharactersOfNames_data() {
        QTest::addColumn<QString>("board");
        for (const char* board : kBoards) {
            QTest::newRow(board) << board;
        }
    }
    void revisionBChangesOnlyCharactersOfNames() {
        QFETCH(QString, board);
        const auto source = read(fileOf(board, ".kicad_pcb"));
        const auto other = read(fileOf(board, "-ipc2581b.xml"));
        QVERIFY(source != nullptr && other != nullptr);
        QCOMPARE(plainNetNames(*other), plainNetNames(*source));
    }
};

QTEST_APPLESS_MAIN(OracleTest)
#include "oracle_test.moc"
