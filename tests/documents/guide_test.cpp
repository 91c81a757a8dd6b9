// What the guide (docs/guide) names is there: commands by their menus, keys, panels, pages, pictures, command lines
// with their options. Every check is proven on a page with a planted fault.
#include <QDir>
#include <QRegularExpression>
#include <QtTest>

#include "tests/cli/program.h"
#include "ui/workspace/actions.h"
#include "ui/workspace/key_presets.h"

namespace {

using ui::ActionSpec;
using ui::MenuId;

QRegularExpressionMatchIterator matchesOf(const char* pattern, const QString& text) {
    return QRegularExpression(QString::fromUtf8(pattern), QRegularExpression::MultilineOption).globalMatch(text);
}

QString contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString withoutMarks(QString text) {
    return text.remove('&').remove(QStringLiteral("…"));
}

/// "View, Panels, Stackup", as the guide says where a command is.
QString placeOf(const ActionSpec& spec) {
    constexpr MenuId kOfView[] = {MenuId::Solid, MenuId::Arrangement, MenuId::Uses, MenuId::Panels,
                                  MenuId::Theme, MenuId::Backend,     MenuId::Keys};
    const QString menu = withoutMarks(ui::menuTitle(spec.menu));
    const bool isDeeper = std::ranges::find(kOfView, spec.menu) != std::end(kOfView);
    return (isDeeper ? "View, " : "") + menu + ", " + withoutMarks(QString::fromUtf8(spec.text));
}

const ActionSpec* commandAt(const QString& place) {
    const auto* const end = std::end(ui::ActionSet::kSpecs);
    const auto* found =
        std::ranges::find_if(ui::ActionSet::kSpecs, [&](const auto& spec) { return placeOf(spec) == place; });
    return found == end ? nullptr : found;
}

QStringList keysOf(const ActionSpec& spec) {
    return QString::fromUtf8(spec.shortcuts).split(' ', Qt::SkipEmptyParts);
}

/// Keys of the table, and those that views, tables and lines take themselves.
bool isKey(const QString& key) {
    static const QStringList kOwn = {"Tab", "Shift+Tab", "Enter", "Del", "Backspace", "F2", "Ctrl+C"};
    return kOwn.contains(key) ||
           std::ranges::any_of(ui::ActionSet::kSpecs, [&](const auto& spec) { return keysOf(spec).contains(key); });
}

/// "**Board, Find clearances** (`Ctrl+Shift+G`)": is there such a command, and does it have this key?
QStringList faultsOfCommands(const QString& text) {
    QStringList faults;
    for (auto found = matchesOf(R"(\*\*([^*]+)\*\*(?: \(`([^`]+)`)?)", text); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const ActionSpec* command = commandAt(match.captured(1).simplified());
        if (command == nullptr) {
            faults += "no such command: " + match.captured(1);
        } else if (match.hasCaptured(2) && !keysOf(*command).contains(match.captured(2))) {
            faults += match.captured(1) + " has no key " + match.captured(2);
        }
    }
    return faults;
}

QStringList faultsOfKeys(const QString& text) {
    constexpr const char* kLikeAKey =
        R"(`((?:(?:Ctrl|Shift|Alt)\+)*(?:[A-Z0-9.,+=?-]|F[0-9]+|Esc|Tab|Del|Space|Enter|Backspace|PgUp|PgDown|Home|Left|Right)(?:,[A-Z0-9]+)?)`)";
    QStringList faults;
    for (auto found = matchesOf(kLikeAKey, text); found.hasNext();) {
        const QString key = found.next().captured(1);
        faults += isKey(key) ? QStringList() : QStringList("no such key: " + key);
    }
    return faults;
}

QStringList faultsOfPanels(const QString& text) {
    QStringList faults;
    for (auto found = matchesOf(R"(\b[Tt]he\s([A-Z][a-z-]+(?:\s[a-z]+)?)\spanel\b)", text); found.hasNext();) {
        const QString panel = found.next().captured(1).simplified();
        faults +=
            commandAt("View, Panels, " + panel) != nullptr ? QStringList() : QStringList("no such panel: " + panel);
    }
    return faults;
}

/// A page links and shows what lies beside it, and nothing else: the window reads this folder alone.
QStringList faultsOfLinks(const QString& text, const QString& folder) {
    QStringList faults;
    for (auto found = matchesOf(R"(\]\(([^)]+)\))", text); found.hasNext();) {
        const QString target = found.next().captured(1);
        const bool isThere = !target.contains('/') && QFileInfo::exists(folder + '/' + target);
        faults += isThere ? QStringList() : QStringList("nothing beside it is called " + target);
    }
    return faults;
}

QString helpOf(const QString& command) {
    static QHash<QString, QString> known;
    if (!known.contains(command)) {
        const QStringList call = command.isEmpty() ? QStringList{"--help"} : QStringList{command, "--help"};
        known[command] = QString::fromUtf8(program::copperscope(call).out);
    }
    return known[command];
}

/// Lines of code: "copperscope clearance board.tgz --rules rules.json".
QStringList faultsOfCalls(const QString& text) {
    QStringList faults;
    for (auto found = matchesOf(R"((?:^|`)copperscope ([^`\n]+))", text); found.hasNext();) {
        const QString call = found.next().captured(1);
        const QString first = call.section(' ', 0, 0);
        const bool isCommand =
            QRegularExpression("\n  " + QRegularExpression::escape(first) + " ").match(helpOf({})).hasMatch();
        const QString help = helpOf(isCommand ? first : QString());
        for (auto option = matchesOf(R"((?:^| )(--?[a-z][a-z-]*))", call); option.hasNext();) {
            const QString name = option.next().captured(1);
            const bool isThere =
                QRegularExpression("(^|[ ,])" + name + "([ ,=]|$)", QRegularExpression::MultilineOption)
                    .match(help)
                    .hasMatch();
            faults += isThere ? QStringList() : QStringList("copperscope " + first + " has no " + name);
        }
        if (!isCommand && QRegularExpression("^[a-z]+$").match(first).hasMatch()) {
            faults += "no such command: copperscope " + first;
        }
    }
    return faults;
}

QStringList faultsOf(const QString& text, const QString& folder) {
    return faultsOfCommands(text) + faultsOfKeys(text) + faultsOfPanels(text) + faultsOfLinks(text, folder) +
           faultsOfCalls(text);
}

const QString kGuide = COPPERSCOPE_GUIDE;

}  // namespace

class GuideTest : public QObject {
    Q_OBJECT

private slots:
    void everythingThatPagesNameIsThere_data() {
        QTest::addColumn<QString>("page");
        for (const QString& page : QDir(kGuide).entryList({"*.md"})) {
            QTest::addRow("%s", qPrintable(page)) << page;
        }
    }

    void everythingThatPagesNameIsThere() {
        QFETCH(QString, page);
        const QString text = contentOf(kGuide + "/" + page);
        QVERIFY(text.startsWith("# "));
        QCOMPARE(faultsOf(text, kGuide).join("; "), QString());
    }

    void everyFileIsReachedFromTheFirstPage() {
        QStringList texts = {contentOf(kGuide + "/README.md")};
        for (const QString& page : QDir(kGuide).entryList({"*.md"})) {
            QVERIFY2(page == "README.md" || texts.first().contains("](" + page + ")"), qPrintable(page));
            texts += contentOf(kGuide + "/" + page);
        }
        qint64 bytes = 0;
        for (const QFileInfo& picture : QDir(kGuide).entryInfoList({"*.png"})) {
            QVERIFY2(texts.join('\n').contains("](" + picture.fileName() + ")"), qPrintable(picture.fileName()));
            const QSize size = program::pngSize(picture.filePath());
            QVERIFY2(size.width() > 0 && size.width() <= 780,
                     qPrintable(picture.fileName()));  // the window is that wide
            bytes += picture.size();
        }
        QVERIFY2(bytes < 1'500'000, qPrintable(QString::number(bytes)));
        QVERIFY(QDir(kGuide).entryList({"*.md", "*.png"}).size() == QDir(kGuide).entryList(QDir::Files).size());
    }

    void plantedFaultsAreNamed_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("fault");
        QTest::newRow("a command that is gone") << "**Board, Find gaps**"
                                                << "no such command: Board, Find gaps";
        QTest::newRow("a command of another menu") << "**File, Find clearances**"
                                                   << "no such command: File, Find clearances";
        QTest::newRow("a submenu left out") << "**View, Stackup**"
                                            << "no such command: View, Stackup";
        QTest::newRow("a key of another command") << "**Board, Find clearances** (`M`)"
                                                  << "Board, Find clearances has no key M";
        QTest::newRow("a key of none") << "press `Ctrl+Shift+F7`"
                                       << "no such key: Ctrl+Shift+F7";
        QTest::newRow("a panel") << "in the Stack panel"
                                 << "no such panel: Stack";
        QTest::newRow("a page") << "[more](gone.md)"
                                << "nothing beside it is called gone.md";
        QTest::newRow("a page elsewhere") << "[more](../keys.md)"
                                          << "nothing beside it is called ../keys.md";
        QTest::newRow("a site") << "[more](https://example.org)"
                                << "nothing beside it is called https://example.org";
        QTest::newRow("a picture") << "![it](gone.png)"
                                   << "nothing beside it is called gone.png";
        QTest::newRow("a call") << "```\ncopperscope look board.tgz\n```"
                                << "no such command: copperscope look";
        QTest::newRow("an option") << "`copperscope info board.tgz --rules x`"
                                   << "copperscope info has no --rules";
    }

    void plantedFaultsAreNamed() {
        QFETCH(QString, text);
        QFETCH(QString, fault);
        QCOMPARE(faultsOf(text, kGuide), QStringList(fault));
    }

    void whatIsThereIsNoFault() {
        const QString text =
            "**Board, Find clearances** (`Ctrl+Shift+G`), **View, Panels, Stackup** (`Ctrl+6`), `Tab`, `U1.3`, "
            "`rules.json`,\n"
            "the Netlist check panel, the Stackup\npanel, [contents](README.md)\n```\ncopperscope board.tgz --step "
            "pcb\n"
            "copperscope render board.tgz -o a.png --view top\n```\n";
        QCOMPARE(faultsOf(text, kGuide).join("; "), QString());
    }
};

QTEST_APPLESS_MAIN(GuideTest)
#include "guide_test.moc"
