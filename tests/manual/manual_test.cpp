// Man pages and completions hold every command and option that --help lists, and complete as a shell asks them to.
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/cli/program.h"

using namespace program;

namespace {

QString contentOf(const QString& name) {
    QFile file(QString(COPPERSCOPE_MANUAL) + "/" + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString helpOf(const QString& command) {
    return QString::fromUtf8(
        copperscope(command.isEmpty() ? QStringList{"--help"} : QStringList{command, "--help"}).out);
}

/// The commands that --help lists.
QStringList commands() {
    QStringList names;
    const QString help = helpOf({});
    const QString list = help.mid(help.indexOf("Subcommands:"));
    QRegularExpressionMatchIterator found =
        QRegularExpression("^  ([a-z]+) ", QRegularExpression::MultilineOption).globalMatch(list);
    while (found.hasNext()) {
        names.append(found.next().captured(1));
    }
    return names;
}

/// "-o", "--output", "--layers" … as --help lists them.
QStringList optionsOf(const QString& command) {
    QStringList names;
    QRegularExpressionMatchIterator rows =
        QRegularExpression("^  (-[a-z-]+(,--?[a-z-]+)*)", QRegularExpression::MultilineOption)
            .globalMatch(helpOf(command));
    while (rows.hasNext()) {
        names.append(rows.next().captured(1).split(','));
    }
    return names;
}

/// What bash offers for the last of these words.
QStringList offered(const QStringList& words, const QString& folder = {}) {
    QProcess bash;
    if (!folder.isEmpty()) {
        bash.setWorkingDirectory(folder);
    }
    bash.start("bash", QStringList{"--norc", "-c",
                                   "source \"$1\"; shift; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _copperscope; "
                                   "printf '%s\\n' \"${COMPREPLY[@]}\"",
                                   "bash", QString(COPPERSCOPE_MANUAL) + "/copperscope.bash"} +
                           words);
    bash.waitForFinished();
    return QString::fromUtf8(bash.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
}

}  // namespace

class ManualTest : public QObject {
    Q_OBJECT

private slots:
    void everyCommandHasItsPage() {
        const QStringList names = commands();
        QVERIFY(names.size() >= 10 && names.contains("info") && names.contains("agree"));
        const QString main = contentOf("copperscope.1");
        for (const QString& name : names) {
            QVERIFY2(main.contains("\\fB" + name + "\\fR"), qPrintable(name));
            QVERIFY2(contentOf("copperscope-" + name + ".1").contains(".SH NAME\ncopperscope\\-" + name + " \\- "),
                     qPrintable(name));
        }
        QCOMPARE(QDir(COPPERSCOPE_MANUAL).entryList({"*.1"}).size(), names.size() + 1);
    }

    void pagesAndCompletionsHaveEveryOption_data() {
        QTest::addColumn<QString>("command");
        QTest::addRow("the program") << QString();
        for (const QString& name : commands()) {
            QTest::addRow("%s", qPrintable(name)) << name;
        }
    }

    void pagesAndCompletionsHaveEveryOption() {
        QFETCH(QString, command);
        const QStringList options = optionsOf(command);
        QVERIFY2(options.size() >= 3, qPrintable(options.join(' ')));
        const QString page = contentOf(command.isEmpty() ? "copperscope.1" : "copperscope-" + command + ".1");
        const QStringList inBash =
            offered(command.isEmpty() ? QStringList{"copperscope", "-"} : QStringList{"copperscope", command, "-"});
        const QString zsh = contentOf("_copperscope");
        const qsizetype begin = command.isEmpty() ? 0 : zsh.indexOf("\n        " + command + ")\n");
        QVERIFY(begin >= 0);
        const QString inZsh = zsh.mid(begin, zsh.indexOf(";;", begin) - begin);
        for (const QString& option : options) {
            QVERIFY2(page.contains("\\fB" + QString(option).replace("-", "\\-") + "\\fR"), qPrintable(option));
            QVERIFY2(inBash.contains(option), qPrintable(option));
            QVERIFY2(QRegularExpression("['{,]\\*?(\\([^)]*\\))?" + option + "[+=]?[\\[,}]").match(inZsh).hasMatch(),
                     qPrintable(option));
        }
        QCOMPARE(inBash.size(), options.size());
    }

    void bashCompletesCommandsChoicesAndFiles() {
        QTemporaryDir folder;
        for (const char* name : {"rest of a board.tgz", "render.png"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        QCOMPARE(offered({"copperscope", "re"}, folder.path()),
                 (QStringList{"render", "render.png", "rest of a board.tgz"}));
        QCOMPARE(offered({"copperscope", "render", "re"}, folder.path()),
                 (QStringList{"render.png", "rest of a board.tgz"}));
        QCOMPARE(offered({"copperscope", "render", "--view", ""}), (QStringList{"top", "bottom", "iso"}));
        QCOMPARE(offered({"copperscope", "render", "--view", "=", "b"}), QStringList{"bottom"});
        QCOMPARE(offered({"copperscope", "render", "--output", "ren"}, folder.path()), QStringList{"render.png"});
        QVERIFY(offered({"copperscope", "render", "--step", ""}, folder.path()).isEmpty());
        QVERIFY(offered({"copperscope", "clearance", "--view", ""}, folder.path()).contains("render.png"));
    }

    /// Behind a command zsh must not take `--format` for that of the program, which has other values.
    void zshLeavesOptionsBehindACommandToIt() {
        QVERIFY(contentOf("_copperscope").contains("_arguments -C -A '-*' \\\n"));
    }

    void pagesSayWhatHelpSays() {
        const QString page = contentOf("copperscope-clearance.1");
        QVERIFY(page.contains("how many of the smallest\n(1 \\- 1000000)\n[100]\n"));
        QVERIFY(contentOf("copperscope-render.1").contains("\\fB\\-\\-output\\fR \\fIFILE\\fR ["));
        QVERIFY(helpOf({}).contains("Exit codes: 0 done") && contentOf("copperscope.1").contains("Exit codes: 0 done"));
    }
};

QTEST_GUILESS_MAIN(ManualTest)
#include "manual_test.moc"
