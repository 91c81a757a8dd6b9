#include "model/export/junit_export.h"

#include "model/export/rule_items.h"
#include "model/text/formatting.h"

namespace model {

namespace {

/// The tests of one suite.
class Suite {
public:
    explicit Suite(std::string className) : m_class(std::move(className)) {}

    void pass(const std::string& name) { add(name, ""); }
    void fail(const std::string& name, const std::string& message) {
        ++m_failures;
        add(name, "<failure type=\"clearance\" message=\"" + xmlText(message) + "\">" + xmlText(name) + '\n' +
                      xmlText(message) + "</failure>");
    }
    void error(const std::string& name, const std::string& message) {
        ++m_errors;
        add(name, "<error type=\"incomplete\" message=\"" + xmlText(message) + "\"/>");
    }
    void skip(const std::string& name, const std::string& message) {
        ++m_skipped;
        add(name, "<skipped message=\"" + xmlText(message) + "\"/>");
    }

    [[nodiscard]] std::string counts() const {
        return formatted(" tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" skipped=\"%zu\" time=\"0\"", m_tests,
                         m_failures, m_errors, m_skipped);
    }
    /// `output` is XML.
    [[nodiscard]] std::string xml(const std::string& name, const std::string& output) const {
        return "  <testsuite name=\"" + xmlText(name) + "\"" + counts() + ">\n" + m_cases +
               (output.empty() ? "" : "    <system-out>" + output + "</system-out>\n") + "  </testsuite>\n";
    }
    void count(const Suite& other) {
        m_tests += other.m_tests;
        m_failures += other.m_failures;
        m_errors += other.m_errors;
        m_skipped += other.m_skipped;
    }

private:
    void add(const std::string& name, const std::string& result) {
        ++m_tests;
        m_cases += "    <testcase classname=\"" + xmlText(m_class) + "\" name=\"" + xmlText(name) + "\" time=\"0\"" +
                   (result.empty() ? "/>\n" : ">\n      " + result + "\n    </testcase>\n");
    }

    std::string m_class;
    std::string m_cases;
    std::size_t m_tests = 0;
    std::size_t m_failures = 0;
    std::size_t m_errors = 0;
    std::size_t m_skipped = 0;
};

void addRule(const RuleTable& table, const StepRules& found, const SideNames& names, std::size_t row, std::size_t most,
             Suite& suite) {
    const Rule& rule = table.rules[row];
    const RuleReport& report = found.report;
    switch (verdictOf(table, report, row)) {
        case Verdict::Off: suite.skip(limitText(rule), "the rule is off"); break;
        case Verdict::Unused: suite.skip(limitText(rule), "unused: " + report.unused[row]); break;
        case Verdict::Passed: suite.pass(limitText(rule)); break;
        default: break;
    }
    const auto listed = findingsOf(found, row, most);
    for (const RuleFinding& finding : listed) {
        suite.fail(placeText(*found.step, names, finding), shortfallText(rule, finding));
    }
    if (report.counts[row] > listed.size()) {
        suite.fail("further locations", std::to_string(report.counts[row] - listed.size()) + " more are not listed");
    }
    for (const WaivedFinding& waived : waivedOf(found, row, most)) {
        suite.skip(placeText(*found.step, names, waived.found),
                   "waived, " + shortfallText(rule, waived.found) + ": " + waived.reason);
    }
    for (const std::string& unchecked : uncheckedOf(report, row)) {
        suite.error("not checked: " + unchecked, unchecked);
    }
}

/// What a step has to say beside its rules; nothing to be said is no suite.
std::string waiverSuite(const StepRules& found, const std::string& className, Suite& all) {
    Suite suite(className);
    for (const WaiverNote& note : found.report.waiverNotes) {
        suite.skip(note.text, std::string("waiver ") + toString(note.state));
    }
    all.count(suite);
    return found.report.waiverNotes.empty() ? "" : suite.xml(className, "");
}

/// Where all tests are skipped, builds would show a pass.
std::string nothingSuite(Suite& all) {
    const std::string name = "design rules";
    Suite suite(name);
    suite.error(kNothingChecked, kNothingChecked);
    all.count(suite);
    return suite.xml(name, "");
}

/// As XML, a line each.
std::string notesOf(const StepRules& found) {
    std::string text;
    for (const NetTie& tie : found.report.netTies) {
        text += xmlText("net tie: " + textOf(*found.step, tie)) + '\n';
    }
    for (const std::string& note : found.report.notes) {
        text += xmlText("note: " + note) + '\n';
    }
    return text;
}

}  // namespace

std::string junitReport(const RuleTable& table, std::span<const StepRules> steps, std::size_t most,
                        const ReportContext& context) {
    Suite all("");
    std::string suites;
    for (const StepRules& found : steps) {
        const SideNames names(*found.step);
        const std::string step = found.step->job.step;
        for (std::size_t row = 0; row < table.rules.size(); ++row) {
            Suite suite(step + '.' + titleOf(table.rules[row]));
            addRule(table, found, names, row, most, suite);
            all.count(suite);
            suites += suite.xml(step + ": " + limitText(table.rules[row]), row == 0 ? notesOf(found) : "");
        }
        suites += waiverSuite(found, step + ".waivers", all);
    }
    suites += isNothingChecked(table, steps) ? nothingSuite(all) : "";
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" +
           xmlText("design rules of " + context.board.filename().string()) + "\"" + all.counts() + ">\n" + suites +
           "</testsuites>\n";
}

}  // namespace model
