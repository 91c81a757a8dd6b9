// The window where it cannot be shown: what is said, and the exit code.
#include <QtTest>

#include "tests/cli/program.h"

using namespace program;

class StartTest : public QObject {
    Q_OBJECT

private slots:
    void withoutADisplayASentenceIsSaid_data() {
        QTest::addColumn<QString>("variable");
        QTest::addColumn<QString>("display");
        QTest::newRow("none") << "DISPLAY"
                              << "";
        QTest::newRow("one that is not there") << "DISPLAY"
                                               << ":54321";
        QTest::newRow("one that cannot be") << "DISPLAY"
                                            << "nonsense";
        QTest::newRow("of Wayland") << "WAYLAND_DISPLAY"
                                    << "nowhere";
        QTest::newRow("no platform of Qt") << "QT_QPA_PLATFORM"
                                           << "nonsense";
    }
    void withoutADisplayASentenceIsSaid() {
        QFETCH(QString, variable);
        QFETCH(QString, display);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "XDG_SESSION_TYPE"}) {
            environment.remove(name);
        }
        environment.insert(variable, display);
        const Outcome run = copperscope({locations::kSample}, {}, environment);
        QVERIFY2(run.exitCode == 3, run.err.constData());
        QVERIFY2(run.err.contains("copperscope: there is no display to show the window on"), run.err.constData());
    }
};

QTEST_GUILESS_MAIN(StartTest)
#include "start_test.moc"
