// Boards that are read, and files that are written, while memory or disk runs out at one moment after another: all of
// it as it is otherwise, or an error and nothing at all.

#include <QtTest>
#include <filesystem>
#include <optional>

#include "model/export/files/export_file.h"
#include "model/text/whole_file.h"
#include "tests/counted_memory.h"
#include "tests/full_disk.h"
#include "tests/locations.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

namespace {

namespace fs = std::filesystem;

/// Of work that asks more often: so many requests are refused, evenly spread. With COPPERSCOPE_THOROUGH=1 each.
constexpr std::size_t kMostRequests = 60;
constexpr std::size_t kMostSizes = 12;

std::size_t strideOf(std::size_t all, std::size_t most) {
    return locations::isThorough() ? 1 : std::max<std::size_t>(all / most, 1);
}

/// All that a board says, and what was said about reading it.
std::string textOf(const model::Document& board) {
    std::string text = odb_testing::fingerprint(board);
    for (const model::Diagnostic& entry : board.diagnostics.entries()) {
        text += entry.file + " " + std::to_string(entry.line) + " " + entry.text + "\n";
    }
    return text;
}

/// Boards that are one file, of each kind. Folders are left out: libstdc++ lists them in functions that may not throw,
/// so that the program ends there, with a message (app/common/memory_limit.cpp), and so would this test.
std::vector<fs::path> boardFiles() {
    std::vector<fs::path> boards = {locations::kSample};
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(locations::kTestData) / "kicad")) {
        boards.push_back(entry.path());
    }
    std::ranges::sort(boards);
    return boards;
}

}  // namespace

class WholeOrNothingTest : public QObject {
    Q_OBJECT

private slots:
    void boardsAreReadWholeOrNotAtAll_data() {
        QTest::addColumn<QString>("path");
        for (const fs::path& board : boardFiles()) {
            QTest::newRow(board.filename().c_str()) << QString::fromStdString(board.string());
        }
    }
    void boardsAreReadWholeOrNotAtAll() {
        QFETCH(QString, path);
        const auto read = [&]() -> std::string {
            base::Progress progress;
            const auto board = model::readBoard(path.toStdString(), {}, progress);
            return board ? textOf(**board) : std::string();
        };
        const std::string expected = read();
        QVERIFY(!expected.empty());
        refuseMemory(
            [&] {
                base::Progress progress;
                return model::readBoard(path.toStdString(), {}, progress);
            },
            [&](const auto* board) { return board == nullptr || !*board || textOf(***board) == expected; });
    }

    void filesAreWrittenWholeOrNotAtAll_data() { addFormats(); }
    void filesAreWrittenWholeOrNotAtAll() {
        const Export work(fetchFormat(), board());
        QVERIFY(work.run());
        const std::string expected = work.takeFiles();
        refuseMemory([&] { return work.run(); },
                     [&](const auto* summary) {
                         const std::string written = work.takeFiles();
                         const bool isWhole = written == expected;
                         // Where memory runs out after the file has its name, it is whole all the same.
                         return summary != nullptr && *summary ? isWhole : isWhole || written.empty();
                     });
    }

    void fullDisksKeepWhatWasThere_data() { addFormats(); }
    void fullDisksKeepWhatWasThere() {
        const Export work(fetchFormat(), board());
        QVERIFY(work.run());
        const std::size_t whole = fs::file_size(work.path());
        (void)work.takeFiles();
        QVERIFY(model::writeWholeFile(work.path(), "before"));
        for (std::size_t size = 0; size < whole; size += strideOf(whole, kMostSizes)) {
            const base::Result<model::ExportSummary> summary = [&] {
                const FullDisk disk(size);
                return work.run();
            }();
            ++m_fullDisks;
            QVERIFY(!summary);
            QCOMPARE(summary.error().code, base::ErrorCode::OutputFailed);
            QCOMPARE(work.files().size(), std::size_t{1});
            QCOMPARE(*model::readWholeFile(work.path()), std::string("before"));
        }
    }

    void cleanupTestCase() {
        qInfo("faults injected: %zu requests for memory refused, %zu of them said", m_refused, m_told);
        qInfo("faults injected: %zu full disks", m_fullDisks);
        QVERIFY(m_refused > 0 && m_told > 0 && m_fullDisks > 0);
    }

private:
    /// A format, and a folder of its own to write to.
    struct Export {
        const model::ExportFormat& format;
        std::shared_ptr<const model::Document> board;
        QTemporaryDir folder;

        Export(const model::ExportFormat& what, std::shared_ptr<const model::Document> of)
            : format(what), board(std::move(of)) {}
        [[nodiscard]] fs::path path() const {
            return folder.filePath("board").toStdString() +
                   std::string(format.endings.substr(0, format.endings.find(' ')));
        }
        [[nodiscard]] std::vector<fs::path> files() const {
            std::vector<fs::path> all;
            for (const fs::directory_entry& entry : fs::directory_iterator(folder.path().toStdString())) {
                all.push_back(entry.path());
            }
            std::ranges::sort(all);
            return all;
        }
        /// The text of all files, which are gone then.
        [[nodiscard]] std::string takeFiles() const {
            std::string all;
            for (const fs::path& file : files()) {
                all += file.filename().string() + "\n" + *model::readWholeFile(file);
                fs::remove(file);
            }
            return all;
        }
        [[nodiscard]] base::Result<model::ExportSummary> run() const {
            base::Progress progress;
            return model::exportBoard(*board, format, {}, path(), progress);
        }
    };

    static void addFormats() {
        QTest::addColumn<int>("format");
        for (std::size_t row = 0; row < model::exportFormats().size(); ++row) {
            QTest::newRow(std::string(model::exportFormats()[row].name).c_str()) << static_cast<int>(row);
        }
    }
    static const model::ExportFormat& fetchFormat() {
        QFETCH(int, format);
        return model::exportFormats()[static_cast<std::size_t>(format)];
    }
    std::shared_ptr<const model::Document> board() {
        if (m_board == nullptr) {
            m_board = odb_testing::read(fs::path(locations::kTestData) / "odb/everything");
        }
        return m_board;
    }

    /// `work` while memory is refused, once and for good, at one request after another; `isGood` looks at what came of
    /// it, null where it ended in std::bad_alloc. Nothing that was taken is left.
    template <class Work, class IsGood>
    void refuseMemory(const Work& work, const IsGood& isGood) {
        const auto normally = [&] {
            const auto result = work();
            return result && isGood(&result);
        };
        QVERIFY(normally());  // what is made once and stays is there now
        const std::size_t first = counted::memory().allocations;
        (void)work();
        const std::size_t requests = counted::memory().allocations - first;
        QVERIFY(normally());
        for (std::size_t request = 1; request <= requests; request += strideOf(requests, kMostRequests)) {
            for (const bool isLasting : {false, true}) {
                const std::size_t before = counted::memory().live;
                const bool isAsItShouldBe = refuse(work, isGood, request, isLasting);
                const std::size_t after = counted::memory().live;
                const std::string what = "request " + std::to_string(request) + " of " + std::to_string(requests) +
                                         (isLasting ? " and all after it: " : ": ");
                QVERIFY2(isAsItShouldBe, (what + "something else came of it").c_str());
                QVERIFY2(after == before,
                         (what + std::to_string(after) + " bytes are taken, not " + std::to_string(before)).c_str());
            }
        }
    }

    template <class Work, class IsGood>
    bool refuse(const Work& work, const IsGood& isGood, std::size_t request, bool isLasting) {
        std::optional<counted::Refusal> refusal(std::in_place, request, isLasting);
        const auto attempt = [&]() -> std::optional<decltype(work())> {
            try {
                return work();
            } catch (const std::bad_alloc&) {
                return std::nullopt;
            }
        };
        const auto result = attempt();
        m_refused += refusal->hasRefused() ? 1 : 0;
        m_told += result && *result ? 0 : 1;
        refusal.reset();
        return isGood(result ? &*result : nullptr);
    }

    std::shared_ptr<const model::Document> m_board;
    std::size_t m_refused = 0;
    std::size_t m_told = 0;
    std::size_t m_fullDisks = 0;
};

QTEST_APPLESS_MAIN(WholeOrNothingTest)
#include "whole_or_nothing_test.moc"
