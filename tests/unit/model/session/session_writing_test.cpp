// What is written beside a board: by one window, by two at once, and where it cannot be.
#include <unistd.h>

#include <QtTest>
#include <atomic>
#include <thread>

#include "model/session/session_news.h"
#include "tests/unit/model/session/session_board.h"

using namespace session_board;
using model::Measurement;
using model::session::KnownPart;
using model::session::LoadedSession;
using model::session::SavedView;
using model::session::saveMeasurements;
using model::session::saveViews;
using model::session::Session;
using model::session::sessionPath;
namespace fs = std::filesystem;

class SessionWritingTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsNoSessionIsNeitherReadNorOverwritten_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("later version") << R"({"copperscope_session": 2, "job": "everything"})";
        QTest::newRow("huge version") << R"({"copperscope_session": 1e300})";
        QTest::newRow("another job") << R"({"copperscope_session": 1, "job": "other", "thickness_nm": {"TOP": 70000}})";
        QTest::newRow("another file") << R"({"name": "something else"})";
        QTest::newRow("no JSON") << "hello";
        QTest::newRow("empty") << "";
        QTest::newRow("cut short") << R"({"copperscope_session": 1, "job")";
        QTest::newRow("deep") << QString(100'000, '[');
        QTest::newRow("large") << QString(2 << 20, ' ');
    }
    void whatIsNoSessionIsNeitherReadNorOverwritten() {
        QFETCH(QString, text);
        const Location location;
        location.write(text.toStdString());
        QVERIFY(location.load().session == Session());
        QCOMPARE(location.load().ignored.size(), std::size_t{1});
        const auto saved = location.save(kOneThickness);
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, base::ErrorCode::OutputFailed);
        QCOMPARE(location.file(), text.toStdString());
    }

    void aFolderThatRefusesLosesNothing() {
        if (::geteuid() == 0) {
            QSKIP("root may write everywhere");
        }
        const Location location;
        QVERIFY(location.save(kOneThickness).ok());
        const std::string before = location.file();
        fs::permissions(location.folder.path(), fs::perms::owner_write, fs::perm_options::remove);
        const auto saved = location.save(kNoThickness);
        fs::permissions(location.folder.path(), fs::perms::owner_write, fs::perm_options::add);
        QVERIFY(!saved);
        QVERIFY(saved.error().text.find(sessionPath(location.board).string()) != std::string::npos);
        QCOMPARE(location.file(), before);
    }

    /// As two windows do that have the same board open.
    void partsThatAreWrittenAtOnceAreAllKept() {
        const Location location;
        constexpr std::size_t kTimes = 50;
        std::atomic<int> lost = 0;
        const auto repeat = [&](const auto& saves, const auto& countOf) {
            return std::jthread([&, saves, countOf] {
                for (std::size_t i = 1; i <= kTimes; ++i) {
                    lost += saves(i).ok() && countOf(location.load().session) == i ? 0 : 1;
                }
            });
        };
        {
            const std::jthread views =
                repeat([&](std::size_t i) { return location.save(std::vector<SavedView>(i, viewNamed("view"))); },
                       [](const Session& session) { return session.views.size(); });
            const std::jthread measurements = repeat(
                [&](std::size_t i) {
                    return saveMeasurements(location.board, *location.document,
                                            std::vector<Measurement>(i, measured("one")));
                },
                [](const Session& session) { return session.measurements.size(); });
        }
        QCOMPARE(lost.load(), 0);
        const LoadedSession found = location.load();
        QVERIFY(found.ignored.empty());
        QCOMPARE(found.session.views.size(), kTimes);
        QCOMPARE(found.session.measurements.size(), kTimes);
        std::size_t files = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(location.folder.path())) {
            ++files;
        }
        QCOMPARE(files, std::size_t{1});
    }

    /// Two windows opened the board, and each writes what it shows.
    void whatTwoWindowsSaveOfOnePartIsAllThere() {
        const Location location;
        KnownPart a;
        KnownPart b;
        QVERIFY(location.save({{"CORE1", 200'000}}, &b).ok());
        QVERIFY(!b.keepsOthers && !b.replacesOthers);
        QVERIFY(location.save({{"CORE2", 300'000}}, &a).ok());
        QVERIFY(a.keepsOthers && !a.replacesOthers);
        QVERIFY(location.save({{"CORE1", 200'000}, {"TOP", 70'000}}, &b).ok());
        QVERIFY(b.keepsOthers && !b.replacesOthers);
        QCOMPARE(location.thicknesses(), (QMap<QString, int>{{"CORE1", 200'000}, {"CORE2", 300'000}, {"TOP", 70'000}}));
        // Undone, and nothing is new to this one.
        QVERIFY(location.save({{"CORE1", 200'000}}, &b).ok());
        QVERIFY(!b.keepsOthers && !b.replacesOthers);
        QCOMPARE(location.thicknesses(), (QMap<QString, int>{{"CORE1", 200'000}, {"CORE2", 300'000}}));
        // What it never showed it replaces, and knows it.
        QVERIFY(location.save({{"CORE1", 200'000}, {"CORE2", 500'000}}, &b).ok());
        QVERIFY(!b.keepsOthers && b.replacesOthers);
        QCOMPARE(location.thicknesses(), (QMap<QString, int>{{"CORE1", 200'000}, {"CORE2", 500'000}}));
    }

    void whatWasReadIsWhatOthersChange() {
        const Location location;
        QVERIFY(location.save(std::vector{viewNamed("a"), viewNamed("b")}).ok());
        KnownPart known{location.load().file, location.load().file};
        QVERIFY(location.save(std::vector{viewNamed("a"), viewNamed("b"), viewNamed("c")}).ok());
        QVERIFY(saveViews(location.board, *location.document, {viewNamed("b"), viewNamed("d")}, &known).ok());
        QVERIFY((location.load().session.views == std::vector{viewNamed("b"), viewNamed("d"), viewNamed("c")}));
        QVERIFY(known.keepsOthers);
    }

    /// Of one window, which saves two parts, while another one saves a third.
    void aSaveTellsWhichOtherPartsOthersChanged() {
        const Location location;
        KnownPart views;
        KnownPart thicknesses;
        QVERIFY(saveViews(location.board, *location.document, {viewNamed("a")}, &views).ok());
        QVERIFY(model::session::otherNews(views, nullptr).empty());
        QVERIFY(model::session::saveMeasurements(location.board, *location.document, {measured("M")}).ok());
        QVERIFY(location.save(kOneThickness, &thicknesses).ok());
        QCOMPARE(model::session::otherNews(thicknesses, views.file.get()), std::vector<std::string>{"measurements"});
        QVERIFY(saveViews(location.board, *location.document, {}, &views).ok());
        QVERIFY(model::session::otherNews(views, thicknesses.file.get()).empty());
    }

    void rulesAreReplacedAsAWhole() {
        const Location location;
        model::RuleTable here = model::defaultRules();
        model::RuleTable there = here;
        here.rules.pop_back();
        there.rules.clear();
        KnownPart known;
        QVERIFY(model::session::saveDesignRules(location.board, *location.document, there).ok());
        QVERIFY(model::session::saveDesignRules(location.board, *location.document, here, &known).ok());
        QVERIFY(known.replacesOthers && !known.keepsOthers);
        QVERIFY(location.load().session.designRules == here);
    }

    /// What is known stays as it was, so nothing of it is taken as removed by others later.
    void whatCouldNotBeWrittenIsNotKnownAsWritten() {
        const Location location;
        KnownPart known;
        fs::create_directories(sessionPath(location.board) / "inside");
        QVERIFY(!location.save(kOneThickness, &known));
        fs::remove_all(sessionPath(location.board));
        QVERIFY(location.save({{"TOP", 70'000}, {"CORE1", 200'000}}, &known).ok());
        QCOMPARE(location.thicknesses(), (QMap<QString, int>{{"CORE1", 200'000}, {"TOP", 70'000}}));
    }

    void aFailedWriteLeavesNoPart() {
        const Location location;
        // A folder where the file should be refuses the rename, whoever runs this.
        fs::create_directories(sessionPath(location.board) / "inside");
        QVERIFY(!location.save(kOneThickness));
        std::size_t entries = 0;
        for (const auto& entry : fs::directory_iterator(location.folder.path())) {
            entries += entry.path() != sessionPath(location.board) ? 1 : 0;
        }
        QCOMPARE(entries, std::size_t{0});
    }
};

QTEST_APPLESS_MAIN(SessionWritingTest)
#include "session_writing_test.moc"
