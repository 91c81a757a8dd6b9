// Each limit of what a file may ask for is reached by a small file, and said with its number (docs/limits.md).
#include "model/base/limits.h"

#include "model/clearance/rule_file.h"
#include "model/clearance/waivers.h"
#include "model/formats/gerber/drills/drill_file.h"
#include "model/formats/gerber/image/image.h"
#include "model/formats/gerber/layer_map.h"
#include "model/formats/kicad/project.h"
#include "model/formats/odb/stackup/matrix.h"
#include "model/formats/registry.h"
#include "model/session/session.h"
#include "model/text/json_reading.h"
#include "model/text/whole_file.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using model::Diagnostics;

namespace {

std::string repeated(std::string_view text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

bool says(const Diagnostics& diagnostics, std::uint64_t limit, const char* what) {
    const std::string words = base::moreThan(limit, what);
    if (findDiagnostic(diagnostics, words) == nullptr) {
        qWarning("nothing says: %s", words.c_str());
        return false;
    }
    return true;
}

bool saysSo(const base::Error& error, const char* words) {
    const bool isSaid = error.code == base::ErrorCode::BadInput && error.text.find(words) != std::string::npos;
    if (!isSaid) {
        qWarning("%s", error.text.c_str());
    }
    return isSaid;
}

base::Result<model::ReadBoard> open(const fs::path& path, const model::ReadOptions& options = {}) {
    base::Progress progress;
    return model::readAnyBoard(path, options, progress);
}

}  // namespace

class LimitsTest : public QObject {
    Q_OBJECT

private slots:
    void archivesMadeToBurstAreRefused() {
        Folder folder;
        const fs::path bomb = folder.path() / "bomb.tgz";
        std::vector<Member> members = membersOf(dataJob("everything"), "job/");
        members.push_back({"job/big", std::string(base::kFreelyUnpackedBytes + 1, '0'), 0644, {}});
        writeArchive(bomb, Container::Ustar, Packing::Gzip, members);
        QVERIFY(fs::file_size(bomb) * base::kMostExpansion < base::kFreelyUnpackedBytes);
        const auto refused = open(bomb);
        QVERIFY(!refused.ok());
        QVERIFY(saysSo(refused.error(), "more than 64 MiB and 250 times its own size"));
        QVERIFY(saysSo(refused.error(), "--max-unpacked sets another limit"));
        model::ReadOptions options;
        options.limits = model::formats::limitsOfUnpacking(2 * base::kFreelyUnpackedBytes);
        QVERIFY(open(bomb, options).ok());
        options.limits = model::formats::limitsOfUnpacking(base::kMiB);
        QVERIFY(saysSo(open(bomb, options).error(), "more than 1 MiB, the limit for a job; --max-unpacked"));
    }

    void filesPackedByThemselvesAreBoundedToo() {
        Folder folder;
        const fs::path bomb = folder.path() / "board.xml.gz";
        writeArchive(bomb, Container::Raw, Packing::Gzip,
                     {{"x", std::string(base::kFreelyUnpackedBytes + 1, ' '), 0644, {}}});
        QVERIFY(saysSo(open(bomb).error(), "more than 64 MiB and 250 times its own size"));
    }

    void archivesInArchivesInArchivesAreLeftClosed() {
        Folder folder;
        writeArchive(folder.path() / "1.tar", Container::Ustar, Packing::Plain, membersOf(dataJob("drills"), "job/"));
        writeArchive(folder.path() / "2.tar", Container::Ustar, Packing::Plain,
                     {{"1.tar", readFile(folder.path() / "1.tar"), 0644, {}}});
        writeArchive(folder.path() / "3.tar", Container::Ustar, Packing::Plain,
                     {{"2.tar", readFile(folder.path() / "2.tar"), 0644, {}}});
        QVERIFY(open(folder.path() / "2.tar").ok());
        QVERIFY(saysSo(open(folder.path() / "3.tar").error(), "this is"));
    }

    void archivesThatAreLeftOutOfALookAreCounted() {
        Folder folder;
        folder.copyJob("drills");
        for (std::size_t i = 0; i <= base::kMostInnerArchives; ++i) {
            folder.write("z" + std::to_string(i) + ".zip", "PK\x03\x04");
        }
        const auto board = open(folder.path());
        QVERIFY(board.ok());
        QVERIFY(findDiagnostic(board->document->diagnostics, "the first 24 were looked into, the limit") != nullptr);
        QVERIFY(findDiagnostic(board->document->diagnostics, "the archive was not looked into") != nullptr);
    }

    void filesThatNeverEndAreRefused() {
        const auto text = model::readWholeFile("/dev/zero", 1'000'000);
        QVERIFY(saysSo(text.error(), "/dev/zero holds more than 1000000 bytes, the limit"));
        QVERIFY(saysSo(model::readRules("/dev/zero").error(), "the limit"));
        QVERIFY(saysSo(model::readWaivers("/dev/zero").error(), "the limit"));
        Diagnostics diagnostics;
        QVERIFY(saysSo(model::gerber::readLayerMap("/dev/zero", diagnostics).error(), "the limit"));
        Folder folder;
        folder.write("exact", std::string(1'000, 'x'));
        QCOMPARE(model::readWholeFile(folder.path() / "exact", 1'000)->size(), std::size_t{1'000});
        QVERIFY(!model::readWholeFile(folder.path() / "exact", 999).ok());
    }

    void valuesThatNestTooDeepAreRefused() {
        const auto nested = [](std::size_t depth) { return repeated("[", depth) + repeated("]", depth); };
        using Json = nlohmann::ordered_json;
        QVERIFY(model::readJson<Json>(nested(base::kMostJsonDepth)).ok());
        const std::string deep = nested(1'000'000);
        QVERIFY(saysSo(model::readJson<Json>(deep).error(), "more than 64 levels, the limit"));
        QVERIFY(saysSo(model::parseRules("{\"copperscope_rules\": 1, \"rules\": " + deep + "}").error(), "64 levels"));
        QVERIFY(saysSo(model::parseWaivers("{\"copperscope_waivers\": 1, \"waivers\": " + deep + "}").error(),
                       "64 levels"));
        Diagnostics diagnostics;
        static_cast<void>(model::kicad::readProject("{\"a\": " + deep + "}", "p", diagnostics));
        QVERIFY(says(diagnostics, base::kMostJsonDepth, "levels"));
        const auto session = model::session::parseSession(
            "{\"copperscope_session\": 1, \"job\": \"\", \"thickness_nm\": {\"T\": " + deep + "}}", model::Document());
        QCOMPARE(session.ignored.size(), std::size_t{1});
        QVERIFY(session.ignored[0].find("64 levels, the limit") != std::string::npos);
    }

    void rowsOfAMatrix() {
        Diagnostics diagnostics;
        const std::string row = "LAYER {\nTYPE=SIGNAL\nNAME=L\n}\n";
        const auto matrix = model::odb::parseMatrix(repeated(row, base::kMostLayers + 1), "matrix", diagnostics);
        QCOMPARE(matrix.layers.size(), base::kMostLayers);
        QVERIFY(says(diagnostics, base::kMostLayers, "layers"));
    }

    void holesByRepetition() {
        const std::string text = "M48\nMETRIC\nT1C0.3\n%\nT1\nX1.0Y1.0\nR60000X0\nR60000X0\nX2.0Y2.0\nM30\n";
        const auto formats = model::gerber::likelyFormats(model::gerber::readDrillHead(text));
        const auto image = model::gerber::parseDrills(text, "test.drl", formats.front());
        QCOMPARE(image.features.size(), std::size_t{60'002});
        QVERIFY(says(image.diagnostics, base::kMostRepeated, "holes"));
    }

    void blocksAndStepsOfImages() {
        std::string blocks = "%FSLAX46Y46*%%MOMM*%%ADD10C,1*%";
        for (std::size_t i = 0; i <= base::kMostBlockDepth; ++i) {
            blocks += "%ABD" + std::to_string(100 + i) + "*%";
        }
        const auto image = model::gerber::parseImage(blocks + "D10*X0Y0D03*M02*", "test.gbr");
        QVERIFY(says(image.diagnostics, base::kMostBlockDepth, "others"));
        const auto copies =
            model::gerber::parseImage("%FSLAX46Y46*%%MOMM*%%ADD10C,1*%%SRX200000Y1I1J1*%D10*X0Y0D03*M02*", "test.gbr");
        QVERIFY(says(copies.diagnostics, base::kMostCopies, "copies"));
        QCOMPARE(copies.features.size(), std::size_t{1});
    }

    void contoursOfTooManyCornersAreLeftOut() {
        std::string surface = "UNITS=MM\nS P 0\nOB 0 0 I\n";
        for (std::size_t i = 0; i <= base::kMostCorners; ++i) {
            surface += i % 2 == 0 ? "OS 1 0\n" : "OS 1 1\n";
        }
        Folder folder;
        writeSmallJob(folder, surface + "OS 1 1\nOS 0 0\nOE\nSE\nS P 0\nOB 0 0 I\nOS 1 0\nOS 1 1\nOS 0 0\nOE\nSE\n");
        const auto board = read(folder.path());
        QVERIFY(says(board->diagnostics, base::kMostCorners, "corners"));
        QCOMPARE(board->elementCounts()[static_cast<std::size_t>(model::ElementKind::Area)], 1U);
    }
};

QTEST_APPLESS_MAIN(LimitsTest)
#include "limits_test.moc"
