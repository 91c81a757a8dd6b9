// The window where it cannot be shown: what is said, and the exit code.
#include <QtTest>

#include "tests/cli/program.h"
#include "tests/patience.h"

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

    void withoutADriverASentenceIsSaid() {
        const bool hasDisplay = !qEnvironmentVariableIsEmpty("DISPLAY");
        const Outcome run = copperscope({locations::kSample}, {}, withoutDriver(hasDisplay ? "xcb" : "offscreen"));
        QVERIFY2(run.exitCode == 3, run.err.constData());
        QVERIFY2(run.err.contains("copperscope: ") && run.err.contains("Vulkan"), run.err.constData());
    }

    /// It waits for somebody to close the dialog.
    void withoutADriverADialogIsShownToWhoStartsFromAMenu() {
        if (qEnvironmentVariableIsEmpty("DISPLAY")) {
            QSKIP("there is no display");
        }
        QProcess process;
        QProcessEnvironment environment = withoutDriver("xcb");
        environment.insert("XDG_CURRENT_DESKTOP", "GNOME");
        process.setProcessEnvironment(environment);
        process.setReadChannel(QProcess::StandardError);
        process.start(locations::kProgram, {locations::kSample});
        QByteArray said;
        while (!said.contains("Vulkan") && process.waitForReadyRead(kPatienceMs)) {
            said += process.readAllStandardError();
        }
        QVERIFY2(said.contains("Vulkan"), said.constData());
        QVERIFY(!process.waitForFinished(2000));
        process.kill();
        process.waitForFinished();
    }

private:
    static QProcessEnvironment withoutDriver(const QString& platform) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove("XDG_CURRENT_DESKTOP");
        environment.insert("QT_QPA_PLATFORM", platform);
        environment.insert("VK_DRIVER_FILES", "/nowhere.json");
        environment.insert("VK_ICD_FILENAMES", "/nowhere.json");
        return environment;
    }
};

QTEST_GUILESS_MAIN(StartTest)
#include "start_test.moc"
