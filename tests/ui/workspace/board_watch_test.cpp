#include "ui/workspace/board_watch.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

#include "tests/patience.h"

using ui::BoardWatch;

namespace fs = std::filesystem;

namespace {

constexpr int kQuietMs = 120;

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

/// As programs save that never leave half a file behind.
void replace(const fs::path& path, const std::string& text) {
    const fs::path beside = path.string() + ".new";
    write(beside, text);
    fs::rename(beside, path);
}

/// A watch over what a board was read from.
struct Watched {
    explicit Watched(const fs::path& path) {
        watch.setQuietMs(kQuietMs);
        watch.begin({path});
        watch.watch({path});
        QTest::qWait(3 * kQuietMs);
    }
    BoardWatch watch;
    QSignalSpy changes{&watch, &BoardWatch::changed};
};

}  // namespace

class BoardWatchTest : public QObject {
    Q_OBJECT

private slots:
    void everyChangeOfAFileIsToldOnce() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "board.kicad_pcb";
        write(board, "one");
        Watched watched(board);
        QCOMPARE(watched.changes.count(), 0);
        write(board, "two, in place");
        QTRY_COMPARE(watched.changes.count(), 1);
        replace(board, "three, put in its place");
        QTRY_COMPARE(watched.changes.count(), 2);
        replace(board, "four, another one put in its place");
        QTRY_COMPARE(watched.changes.count(), 3);
        write(board, "five, in place of what replaced it");
        QTRY_COMPARE(watched.changes.count(), 4);
        QTest::qWait(4 * kQuietMs);
        QCOMPARE(watched.changes.count(), 4);
    }

    void aFileThatIsWrittenInPiecesCountsWhenItIsWhole() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "board.xml";
        write(board, "one");
        Watched watched(board);
        watched.watch.setQuietMs(10 * kQuietMs);  // a busy machine may take its time between two pieces
        std::ofstream file(board, std::ios::binary);
        for (int piece = 0; piece < 20; ++piece) {
            file << "piece" << std::flush;
            QTest::qWait(kQuietMs);
            QCOMPARE(watched.changes.count(), 0);
        }
        file.close();
        QTRY_COMPARE(watched.changes.count(), 1);
    }

    void aFileThatIsGoneIsWaitedFor() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "board.tgz";
        write(board, "one");
        Watched watched(board);
        fs::remove(board);
        QTest::qWait(4 * kQuietMs);
        QCOMPARE(watched.changes.count(), 0);
        write(board, "here again");
        QTRY_COMPARE(watched.changes.count(), 1);
    }

    void whatLiesBesideAFileIsNoChangeButItsProjectAndItsRulesAre() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "board.kicad_pcb";
        write(board, "one");
        write(board.parent_path() / "board.kicad_pro", "{}");
        Watched watched(board);
        write(board.parent_path() / "board.kicad_pcb.copperscope.json", "{}");
        write(board.parent_path() / "other.kicad_pcb", "another");
        QTest::qWait(4 * kQuietMs);
        QCOMPARE(watched.changes.count(), 0);
        replace(board.parent_path() / "board.kicad_pro", "{ }");
        QTRY_COMPARE(watched.changes.count(), 1);
        write(board.parent_path() / "board.kicad_dru", "(version 1)");
        QTRY_COMPARE(watched.changes.count(), 2);
    }

    void filesOfAFolderThatComeGoOrChangeAreTold() {
        QTemporaryDir folder;
        const fs::path job = fs::path(folder.path().toStdString()) / "job";
        write(job / "top.gtl", "one");
        write(job / "drills" / "thru.drl", "one");
        Watched watched(job);
        write(job / "drills" / "thru.drl", "two, below");
        QTRY_COMPARE(watched.changes.count(), 1);
        write(job / "bottom.gbl", "one");
        QTRY_COMPARE(watched.changes.count(), 2);
        fs::remove(job / "top.gtl");
        QTRY_COMPARE(watched.changes.count(), 3);
        write(job / "bottom.gbl", "the new one is watched too");
        QTRY_COMPARE(watched.changes.count(), 4);
    }

    void filesOfFoldersThatLinksLeadToAreTold() {
        QTemporaryDir folder;
        const fs::path job = fs::path(folder.path().toStdString()) / "job";
        const fs::path elsewhere = fs::path(folder.path().toStdString()) / "elsewhere";
        write(job / "top.gtl", "one");
        write(elsewhere / "thru.drl", "one");
        fs::create_directory_symlink("../elsewhere", job / "drills");
        fs::create_directory_symlink("..", job / "up");  // is not read
        Watched watched(job);
        write(elsewhere / "thru.drl", "two, in place");
        QTRY_COMPARE(watched.changes.count(), 1);
        replace(elsewhere / "thru.drl", "three, put in its place");
        QTRY_COMPARE(watched.changes.count(), 2);
        write(job.parent_path() / "other.gtl", "of another board");
        QTest::qWait(4 * kQuietMs);
        QCOMPARE(watched.changes.count(), 2);
    }

    void whatLiesBesideAJobFileIsOfIt() {
        QTemporaryDir folder;
        const fs::path job = fs::path(folder.path().toStdString()) / "job";
        write(job / "board.gbrjob", R"({"GeneralSpecs": {}, "FilesAttributes": []})");
        write(job / "top.gtl", "one");
        Watched watched(job / "board.gbrjob");
        write(job / "top.gtl", "two, in place");
        QTRY_COMPARE(watched.changes.count(), 1);
    }

    void whatChangesWhileTheBoardIsReadIsTold() {
        QTemporaryDir folder;
        const fs::path board = fs::path(folder.path().toStdString()) / "board.xml";
        write(board, "one");
        BoardWatch watch;
        watch.setQuietMs(kQuietMs);
        QSignalSpy changes(&watch, &BoardWatch::changed);
        watch.begin({board});
        write(board, "two, half way through");
        watch.watch({board});
        QTRY_COMPARE(changes.count(), 1);
    }
};

QTEST_MAIN(BoardWatchTest)
#include "board_watch_test.moc"
