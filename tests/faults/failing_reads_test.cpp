// Boards and files beside them, read from a disk that fails at one moment after another: all of them as they are
// otherwise, or an error, or a message that names what could not be read.

#include "tests/failing_reads.h"

#include <QtTest>
#include <filesystem>

#include "model/board/document.h"
#include "model/formats/registry.h"
#include "model/session/session.h"
#include "model/text/whole_file.h"
#include "tests/locations.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

namespace {

namespace fs = std::filesystem;

/// Of boards that ask for more reads: so many fail, evenly spread. With COPPERSCOPE_THOROUGH=1 each.
constexpr std::size_t kMostReads = 40;

base::Result<std::shared_ptr<const model::Document>> read(const fs::path& board) {
    base::Progress progress;
    return model::readBoard(board, {}, progress);
}

/// Does it say that something cannot be read, in our words or in those of the archive library?
bool isOfReading(const std::string& text) {
    return text.find("cannot be read") != std::string::npos || text.find("Error reading") != std::string::npos;
}

/// Messages about what cannot be read; some boards hold records of which that is said in any case.
std::ptrdiff_t countTold(const model::Document& board) {
    return std::ranges::count_if(board.diagnostics.entries(),
                                 [](const model::Diagnostic& entry) { return isOfReading(entry.text); });
}

}  // namespace

class FailingReadsTest : public QObject {
    Q_OBJECT

private slots:
    void boardsThatCannotBeReadSaySo_data() {
        QTest::addColumn<QString>("path");
        QTest::newRow("an archive") << QString(locations::kSample);
        QTest::newRow("IPC-2581") << QString(locations::kFuzzCorpus) + "/ipc2581/board_c.xml";
        for (const char* name :
             {"odb/everything", "odb/panel", "kicad/small.kicad_pcb", "gerber-conformance/apertures",
              "gerber-conformance/combined", "gerber-conformance/drill", "boards/kicad/StickHub.tgz"}) {
            const fs::path path = fs::path(locations::kTestData) / name;
            QVERIFY2(fs::exists(path), name);
            QTest::newRow(name) << QString::fromStdString(path.string());
        }
    }
    void boardsThatCannotBeReadSaySo() {
        QFETCH(QString, path);
        const fs::path board = path.toStdString();
        std::size_t reads = 0;
        const auto whole = [&] {
            const FailingReads none(0);
            auto got = read(board);
            reads = none.reads();
            return got;
        }();
        QVERIFY(whole);
        const std::string expected = odb_testing::fingerprint(**whole);
        QVERIFY(reads > 0);
        const std::size_t stride = locations::isThorough() ? 1 : std::max<std::size_t>(reads / kMostReads, 1);
        for (std::size_t nth = 1; nth <= reads; nth += stride) {
            for (const bool isLasting : {false, true}) {
                const auto got = [&] {
                    const FailingReads failing(nth, isLasting);
                    return read(board);
                }();
                ++m_failed;
                m_told += got ? 0 : 1;
                const bool isGood =
                    got ? countTold(**got) > countTold(**whole) || odb_testing::fingerprint(**got) == expected
                        : isOfReading(got.error().text);
                const std::string what = "read " + std::to_string(nth) + " of " + std::to_string(reads) +
                                         (isLasting ? " and all after it: " : ": ");
                QVERIFY2(isGood, (what + (got ? "something is missing" : got.error().text)).c_str());
            }
        }
    }

    void aSessionThatCannotBeReadIsNotLost() {
        const QTemporaryDir folder;
        const fs::path board = fs::path(folder.filePath("small.kicad_pcb").toStdString());
        fs::copy_file(fs::path(locations::kTestData) / "kicad/small.kicad_pcb", board);
        const auto document = read(board);
        QVERIFY(document);
        QVERIFY(model::session::saveNets(board, **document, {{"GND", "", std::nullopt, true}}));
        const std::string before = *model::readWholeFile(model::session::sessionPath(board));
        {
            const FailingReads failing(1);
            const model::session::LoadedSession loaded = model::session::loadSession(board, **document);
            QCOMPARE(loaded.session, model::session::Session());
            QCOMPARE(loaded.ignored.size(), std::size_t{1});
            QVERIFY(isOfReading(loaded.ignored.front()));
            const base::Status saved = model::session::saveNets(board, **document, {{"VCC", "", std::nullopt, true}});
            QVERIFY(!saved);
            QVERIFY(isOfReading(saved.error().text));
        }
        QCOMPARE(*model::readWholeFile(model::session::sessionPath(board)), before);
        m_failed += 2;
        m_told += 2;
    }

    void cleanupTestCase() {
        qInfo("faults injected: %zu reads that failed, %zu of them ended in an error", m_failed, m_told);
        QVERIFY(m_failed > 0 && m_told > 0);
    }

private:
    std::size_t m_failed = 0;
    std::size_t m_told = 0;
};

QTEST_APPLESS_MAIN(FailingReadsTest)
#include "failing_reads_test.moc"
