#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QtTest>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>

#include "tests/soak/action_log.h"
#include "tests/soak/driver.h"
#include "tests/soak/modes.h"
#include "tests/soak/resources.h"
#include "ui/common/paths.h"
#include "ui/comparison/comparison_feature.h"
#include "ui/export/export_dialog.h"

namespace soak {

using ui::ActionId;

namespace {

/// Each question has a list of findings of its own.
template <ui::ClearancePanel::What What>
void choose(Driver& driver) {
    QWidget& panel = driver.window().panel("clearances");
    panel.findChild<QComboBox*>("what")->setCurrentIndex(static_cast<int>(What));
    panel.findChild<QComboBox*>("where")->setCurrentIndex(static_cast<int>(ui::ClearancePanel::Where::Board));
}

void search(Driver& driver) {
    driver.trigger(ActionId::SearchClearances);
}

void exportAs(Driver& driver, const char* format, const char* name) {
    driver.trigger(ActionId::ExportBoard);
    auto& dialog = *driver.window().findChild<ui::ExportDialog*>();
    auto& formats = *dialog.findChild<QComboBox*>("exportFormat");
    formats.setCurrentIndex(formats.findText(format, Qt::MatchStartsWith));
    auto& line = *dialog.findChild<QLineEdit*>("exportFile");
    line.setText(ui::fromPath(driver.outputFolder() / name));
    QTest::keyClick(&line, Qt::Key_Return);
}

/// Something that can be stopped.
struct Work {
    const char* name;
    void (*begin)(Driver& driver);
    void (*prepare)(Driver& driver) = [](Driver&) {};  ///< what is no part of it
};
// clang-format off
constexpr Work kWorks[] = {
    {"load", [](Driver& driver) { driver.open(1); }},
    {"search", search, choose<ui::ClearancePanel::What::Smallest>},
    {"rules", search, choose<ui::ClearancePanel::What::Rules>},
    {"through stackup", search, choose<ui::ClearancePanel::What::ThroughStackup>},
    {"netlist check", [](Driver& driver) { driver.trigger(ActionId::CheckNets); }},
    {"comparison",
     [](Driver& driver) {
         driver.window().find<ui::ComparisonFeature>().start(ui::fromPath(driver.boards()[1]));
     }},
    {"export STEP", [](Driver& driver) { exportAs(driver, "STEP", "a.step"); }},
    {"export GLB", [](Driver& driver) { exportAs(driver, "GLB", "a.glb"); }},
    {"save picture",
     [](Driver& driver) { driver.window().savePicture(ui::fromPath(driver.outputFolder() / "a.png"), 2000); }},
    {"export PDF", [](Driver& driver) { exportAs(driver, "PDF", "a.pdf"); }},
};
// clang-format on

/// What a stopped work must leave as it was.
struct State {
    const model::Document* document = nullptr;
    std::size_t elementsSelected = 0;
    std::size_t netsSelected = 0;
    int findings = 0;
    int measurements = 0;
    int undoSteps = 0;
    QString title;
    std::vector<std::string> visibleLayers;
    std::vector<std::string> outputs;

    bool operator==(const State&) const = default;
};

std::string textOf(const State& state) {
    std::string text = state.title.toStdString() + (state.document != nullptr ? ", a board" : ", no board");
    const auto add = [&text](std::size_t count, const char* what) {
        text += ", " + std::to_string(count) + " " + what;
    };
    add(state.elementsSelected, "elements selected");
    add(state.netsSelected, "nets selected");
    add(static_cast<std::size_t>(state.findings), "findings");
    add(static_cast<std::size_t>(state.measurements), "measurements");
    add(static_cast<std::size_t>(state.undoSteps), "steps to undo");
    add(state.visibleLayers.size(), "visible layers");
    for (const std::string& name : state.outputs) {
        text += ", " + name;
    }
    return text;
}

State stateOf(Driver& driver) {
    TestWindow& window = driver.window();
    return {window.document(),
            window.selection().selected().size(),
            window.selection().nets().size(),
            window.find<ui::ClearanceModel>().rowCount(),
            window.measurements().rowCount(),
            window.workspace().history().count(),
            window.windowTitle(),
            window.layers().visibleNames(),
            driver.outputs()};
}

class Cancels {
public:
    explicit Cancels(const Options& options) : m_options(options), m_dice(options.seed), m_driver(options.boards) {}

    bool run() {
        m_driver.open(0);
        if (!m_driver.settle() || !m_driver.hasBoard()) {
            return fail("the board was not opened");
        }
        measureAll();
        m_threads = threadsNow();
        while (m_cancelled < m_options.count) {
            if (!cancelOne(m_cancelled % std::size(kWorks))) {
                return false;
            }
        }
        print();
        return !m_hasFailed && drawSections();
    }

private:
    struct Times {
        int wholeMs = 0;
        std::size_t cancelled = 0;
        int longestEndMs = 0;  ///< from the cancel until its threads were gone
    };

    /// How long each takes, so that moments can be drawn.
    void measureAll() {
        for (std::size_t i = 0; i < std::size(kWorks); ++i) {
            QElapsedTimer clock;
            clock.start();
            kWorks[i].prepare(m_driver);
            kWorks[i].begin(m_driver);
            m_driver.settle();
            m_times[i].wholeMs = static_cast<int>(clock.elapsed());
            if (i == 0) {  // the others are stopped at the first board
                m_driver.open(0);
                m_driver.settle();
            }
        }
        m_wholeFiles = fileSizes();
        m_driver.removeOutputs();
    }

    bool cancelOne(std::size_t row) {
        ActionLog::instance().add(std::string(kWorks[row].name) + " (cancel " + std::to_string(m_cancelled) + ")");
        kWorks[row].prepare(m_driver);
        const State before = stateOf(m_driver);
        kWorks[row].begin(m_driver);
        m_driver.rest(m_dice.between(0, m_times[row].wholeMs));
        if (!m_driver.stopWork()) {
            return afterTheEnd(row);
        }
        if (m_driver.window().workspace().isWorking()) {
            return fail("Esc did not stop it");
        }
        QElapsedTimer clock;
        clock.start();
        if (!m_driver.awaitThreads(m_threads)) {
            return fail("its threads did not end");
        }
        if (!fileSizes().empty() && areWhole(fileSizes())) {
            return afterTheEnd(row);  // its thread was done, and the window had not asked yet
        }
        m_times[row].longestEndMs = std::max(m_times[row].longestEndMs, static_cast<int>(clock.elapsed()));
        ++m_times[row].cancelled;
        ++m_cancelled;
        return isAsBefore(before);
    }

    [[nodiscard]] std::map<std::string, std::uintmax_t> fileSizes() const {
        std::map<std::string, std::uintmax_t> sizes;
        for (const std::string& name : m_driver.outputs()) {
            sizes[name] = std::filesystem::file_size(m_driver.outputFolder() / name);
        }
        return sizes;
    }

    /// As long as what exports write that nobody stops.
    [[nodiscard]] bool areWhole(const std::map<std::string, std::uintmax_t>& files) const {
        return std::ranges::all_of(files, [this](const auto& file) {
            const auto whole = m_wholeFiles.find(file.first);
            return whole != m_wholeFiles.end() && whole->second == file.second;
        });
    }

    bool isAsBefore(const State& before) {
        const State now = stateOf(m_driver);
        if (now == before) {
            return true;
        }
        std::fprintf(stderr, "soak: before: %s\nsoak: now:    %s%s\n", textOf(before).c_str(), textOf(now).c_str(),
                     now.document != before.document ? ", another board" : "");
        return fail("something is not as it was before");
    }

    /// It was too late to stop it.
    bool afterTheEnd(std::size_t row) {
        ++m_tooLate;
        m_times[row].wholeMs = m_times[row].wholeMs * 9 / 10;
        m_driver.settle();
        m_driver.removeOutputs();
        if (row == 0) {
            m_driver.open(0);
            m_driver.settle();
        }
        return m_tooLate <= m_options.count + 100 || fail("nearly all of it ends before it can be stopped");
    }

    /// The line of a section, given up while it is drawn, is what it was.
    bool drawSections() {
        m_driver.trigger(ActionId::ShowSideBySide);
        for (std::size_t i = 0; i < m_options.count / std::size(kWorks) + 1; ++i) {
            ActionLog::instance().add("section (cancel)");
            ui::BoardView& flat = m_driver.window().views().flat();
            const auto before = m_driver.window().find<ui::SectionLine>().line();
            m_driver.trigger(ActionId::DrawSection);
            for (int corner = m_dice.between(0, 3); corner > 0; --corner) {
                m_driver.click(flat, Driver::locationIn(flat, m_dice));
            }
            m_driver.key(Qt::Key_Escape);
            if (m_driver.window().find<ui::SectionLine>().isDrawing() ||
                !(m_driver.window().find<ui::SectionLine>().line() == before)) {
                return fail("the line of the section is not as it was");
            }
            ++m_sections;
        }
        std::printf("%-16s %6zu cancelled\n", "section", m_sections);
        return true;
    }

    void print() const {
        std::printf("cancels: %zu at random moments, seed %llu\n", m_cancelled,
                    static_cast<unsigned long long>(m_options.seed));
        for (std::size_t i = 0; i < std::size(kWorks); ++i) {
            std::printf("%-16s %6zu cancelled, longest until its threads were gone %d ms\n", kWorks[i].name,
                        m_times[i].cancelled, m_times[i].longestEndMs);
        }
    }

    bool fail(const char* why) {
        std::fprintf(stderr, "soak: %s\n", why);
        ActionLog::instance().print();
        m_hasFailed = true;
        return false;
    }

    const Options& m_options;
    Dice m_dice;
    Driver m_driver;
    std::array<Times, std::size(kWorks)> m_times{};
    std::map<std::string, std::uintmax_t> m_wholeFiles;
    std::size_t m_threads = 0;
    std::size_t m_cancelled = 0;
    std::size_t m_tooLate = 0;
    std::size_t m_sections = 0;
    bool m_hasFailed = false;
};

}  // namespace

bool cancelAtRandom(const Options& options) {
    return Cancels(options).run();
}

}  // namespace soak
