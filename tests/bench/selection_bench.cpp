// How long the window is busy when the largest area of a board is pointed at or selected: selection_bench BOARD...
// Needs a display (Xvfb will do). An event loop that is busy answers nobody: prints the longest and the median time
// between two of its turns, in ms of the clock and of the thread's own processor time, which other programs on the
// machine change less; and beside them those of the smallest element, as the baseline of the same run.

#include <QApplication>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <vector>

#include "model/board/single_element.h"
#include "tests/ui/window_fixture.h"

namespace {

constexpr int kRepeats = 7;
constexpr int kWatchedMs = 700;  // the picture of the element comes 60 ms later, and is modelled beside

double cpuMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double clockMs() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Busy {
    std::vector<double> clock;
    std::vector<double> cpu;
};

/// The longest turns of the event loop while and after `act` was done.
template <class Act>
void measure(const Act& act, Busy& out) {
    double longest = 0.0;
    double longestCpu = 0.0;
    const auto turn = [&](const auto& work) {
        const double start = clockMs();
        const double startCpu = cpuMs();
        work();
        longest = std::max(longest, clockMs() - start);
        longestCpu = std::max(longestCpu, cpuMs() - startCpu);
    };
    turn(act);
    for (const double end = clockMs() + kWatchedMs; clockMs() < end;) {
        turn([] { QCoreApplication::processEvents(QEventLoop::AllEvents); });
    }
    out.clock.push_back(longest);
    out.cpu.push_back(longestCpu);
}

void print(const char* what, Busy& busy) {
    for (std::vector<double>* times : {&busy.clock, &busy.cpu}) {
        std::ranges::sort(*times);
    }
    std::printf("  %-24s longest %6.1f ms, median %6.1f ms; processor %6.1f, %6.1f\n", what, busy.clock.back(),
                busy.clock[busy.clock.size() / 2], busy.cpu.back(), busy.cpu[busy.cpu.size() / 2]);
}

void bench(ui::SelectionModel& selection, model::ElementId element, const char* hovered, const char* selected) {
    Busy hover;
    Busy select;
    for (int i = 0; i < kRepeats; ++i) {
        measure([&] { selection.hover(model::BoardElement{0, element}); }, hover);
        measure([&] { selection.select({{0, element}}); }, select);
        selection.hover(std::nullopt);
        while (selection.clearStep()) {
        }
        Busy settling;  // the frame without the selection is none of what is measured
        measure([] {}, settling);
    }
    print(hovered, hover);
    print(selected, select);
}

}  // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    for (int i = 1; i < argc; ++i) {
        WindowFixture fixture;
        if (!fixture.openAndWait(QString::fromLocal8Bit(argv[i]))) {
            std::fprintf(stderr, "selection_bench: %s cannot be opened\n", argv[i]);
            return 2;
        }
        const model::Document& board = *fixture.window().document();
        std::vector<std::size_t> nodes;
        for (std::size_t row = 0; row < board.elements.size(); ++row) {
            nodes.push_back(model::nodeCountOf(board, model::ElementId{row}));
        }
        const auto [least, most] = std::ranges::minmax_element(nodes);
        std::printf("%s: %zu nodes in the largest area\n", argv[i], *most);
        ui::SelectionModel& selection = fixture.window().selection();
        Busy settling;  // after opening, views are drawn once more at rest
        measure([] {}, settling);
        bench(selection, model::ElementId{std::size_t(most - nodes.begin())}, "largest, hovered", "largest, selected");
        bench(selection, model::ElementId{std::size_t(least - nodes.begin())}, "smallest, hovered",
              "smallest, selected");
        std::fflush(stdout);
    }
    return 0;
}
