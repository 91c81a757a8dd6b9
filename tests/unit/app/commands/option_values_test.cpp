// How the values of options are read, held against every option of every command.
#include "app/commands/option_values.h"

#include <CLI/CLI.hpp>
#include <QtTest>

#include "app/commands/command_line.h"

namespace {

/// The program's parser after it has read these words, and what it says of them.
struct Parsed {
    std::shared_ptr<CLI::App> parser;
    std::string error;
    app::Command chosen{};
};

std::shared_ptr<Parsed> parsed(std::vector<std::string> words) {
    auto result = std::make_shared<Parsed>();
    char name[] = "copperscope";
    char* argv[] = {name, nullptr};
    result->parser = app::makeCommandLine(1, argv, result->chosen);
    std::ranges::reverse(words);  // as the parser wants them
    try {
        result->parser->parse(words);
    } catch (const CLI::ParseError& error) {
        result->error = error.what();
    }
    return result;
}

/// The command of that name; the workbench's has none.
CLI::App& commandOf(const Parsed& result, const std::string& name) {
    return name.empty() ? *result.parser : *result.parser->get_subcommand(name);
}

std::vector<std::string> wordsOf(const std::string& command, const std::vector<std::string>& rest) {
    std::vector<std::string> words;
    if (!command.empty()) {
        words.push_back(command);
    }
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
}

bool takesValue(const CLI::Option* option) {
    return option->get_items_expected_max() > 0 && !option->get_positional();
}

}  // namespace

class OptionValuesTest : public QObject {
    Q_OBJECT

    /// A row for every option with a value.
    static void addOptions() {
        QTest::addColumn<std::string>("command");
        QTest::addColumn<std::string>("name");
        const auto add = [](const CLI::App& command, const std::string& name) {
            for (const CLI::Option* option : command.get_options(takesValue)) {
                QTest::addRow("%s %s", name.c_str(), option->get_name().c_str()) << name << option->get_name();
            }
        };
        const auto all = parsed({});
        add(*all->parser, "");
        for (const CLI::App* command : all->parser->get_subcommands([](const CLI::App*) { return true; })) {
            add(*command, command->get_name());
        }
    }

private slots:
    void anOptionTakesOneWord_data() { addOptions(); }

    void anOptionTakesOneWord() {
        QFETCH(std::string, command);
        QFETCH(std::string, name);
        // What no number is, but for a size: a limit of memory that does not limit this test.
        if (command == "generate") {
            return;  // it reads no board
        }
        const auto result = parsed(wordsOf(command, {name, "99T", "a.tgz", "b.tgz"}));
        const CLI::App& parser = commandOf(*result, command);
        QCOMPARE(parser.get_option(name)->results().size(), 1U);
        QCOMPARE(parser.get_option(command == "agree" ? "A" : "BOARD")->results().front(), std::string("a.tgz"));
    }

    void noValueIsEmpty_data() { addOptions(); }

    void noValueIsEmpty() {
        QFETCH(std::string, command);
        QFETCH(std::string, name);
        QCOMPARE(parsed(wordsOf(command, {name, ""}))->error, name + ": the value is empty");
        const std::string assigned = name + '=';
        const char* argv[] = {"copperscope", "info", assigned.c_str(), "a.tgz"};
        QCOMPARE(app::emptyAssignment(4, argv), name + ": the value is empty");
    }

    void whatMayBeGivenSeveralTimesStillIs() {
        const auto render = parsed({"render", "--net", "A,B", "a.tgz", "--net", "C", "-o", "x.png"});
        QCOMPARE(commandOf(*render, "render").get_option("--net")->results(), (std::vector<std::string>{"A,B", "C"}));
        const auto info = parsed({"info", "--set-thickness", "A=1um", "--set-thickness", "B=1um", "a.tgz"});
        QCOMPARE(commandOf(*info, "info").get_option("--set-thickness")->results().size(), 2U);
        QVERIFY2(info->error.empty(), info->error.c_str());
    }

    void wrongValuesAreRefused_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* words, const char* why) { QTest::newRow(words) << QString(words) << why; };
        row("info --max-unpacked -5", "-5 is no size above 0");
        row("info --max-memory 0", "0 is no size above 0");
        row("info --max-memory 0G", "0G is no size above 0");
        row("info --max-memory -1", "-1 is no size above 0");
        row("generate --seed -1", "-1 is no whole number from 0 up");
        row("clearance --worst 0x10", "0x10 is no whole number");
        row("info --chord 0x10", "0x10 is no number");
        row("info --chord inf", "inf is no number");
        row("bench --threads 1,2.5", "2.5 is not one of");
        row("render --size 100x", "WIDTHxHEIGHT");
        row("render --size x100", "WIDTHxHEIGHT");
        row("render --window 1,2,3 a.tgz", "takes 4 values");
        row("render --z-scale 10,0", "0 is not one of");
        row("clearance --nets A", "takes 2 values");
        row("section --line 0,0,1,1 --line 2,2,3,3", "--line");
        row("section --line 0,0,,1", "between commas");
        row("export --layers A,", "between commas");
        row("agree --aspects copper,colour", "colour is none of copper");
        row("clearance --rules -", "./- is the file");
        row("clearance -o -", "./- is the file");
    }

    void wrongValuesAreRefused() {
        QFETCH(QString, words);
        QFETCH(QString, why);
        std::vector<std::string> each;
        for (const QString& word : words.split(' ')) {
            each.push_back(word.toStdString());
        }
        const std::string error = parsed(each)->error;
        QVERIFY2(QString::fromStdString(error).contains(why), error.c_str());
    }

    void valuesAreReadAsPeopleWriteThem() {
        CLI::App parser;
        std::vector<std::string> names;
        std::vector<double> numbers;
        int count = 0;
        app::addNames(parser, "--names", names, "");
        app::addNumbers(parser, "--numbers", numbers, "");
        parser.add_option("--count", count);
        app::checkValues(parser);
        parser.parse(std::vector<std::string>{"010", "--count", "-1, +2.5", "--numbers", "[A] , B C", "--names"});
        QCOMPARE(names, (std::vector<std::string>{"[A]", "B C"}));
        QCOMPARE(numbers, (std::vector<double>{-1.0, 2.5}));
        QCOMPARE(count, 10);
    }
};

QTEST_GUILESS_MAIN(OptionValuesTest)
#include "option_values_test.moc"
