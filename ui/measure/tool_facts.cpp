#include "ui/measure/tool_facts.h"

namespace ui {

namespace {

/// As in MeasureFeature::Tool.
constexpr ToolFacts kTools[] = {
    {Catch::Points, 0, {}, ""},
    {Catch::Points,
     2,
     {QT_TRANSLATE_NOOP("ui::Measuring", "Click the first point; Alt snaps to nothing, Tab to what lies beneath"),
      QT_TRANSLATE_NOOP("ui::Measuring", "Second point; Shift straight, Ctrl 45°")},
     QT_TRANSLATE_NOOP("ui::Measuring", "Click on the board")},
    {Catch::Elements,
     2,
     {QT_TRANSLATE_NOOP(
          "ui::Measuring",
          "Click the first element or the board's edge; Alt takes the hole in a pad, Tab what lies beneath"),
      QT_TRANSLATE_NOOP("ui::Measuring", "Click the second element or the board's edge; Tab takes what lies beneath")},
     QT_TRANSLATE_NOOP("ui::Measuring", "There is no element under the pointer")},
    {Catch::Points,
     3,
     {QT_TRANSLATE_NOOP("ui::Measuring", "Click the corner of the angle"),
      QT_TRANSLATE_NOOP("ui::Measuring", "Click a point on its first arm; Shift straight, Ctrl in steps of 45°"),
      QT_TRANSLATE_NOOP("ui::Measuring", "Click a point on its second arm; Shift straight, Ctrl in steps of 45°")},
     QT_TRANSLATE_NOOP("ui::Measuring", "Click on the board")},
    {Catch::Straight,
     2,
     {QT_TRANSLATE_NOOP("ui::Measuring", "Click the first straight track or side"),
      QT_TRANSLATE_NOOP("ui::Measuring", "Click the second straight track or side")},
     QT_TRANSLATE_NOOP("ui::Measuring", "There is nothing straight under the pointer")},
    {Catch::Round,
     1,
     {QT_TRANSLATE_NOOP("ui::Measuring", "Click an arc, a round pad or a hole for its radius")},
     QT_TRANSLATE_NOOP("ui::Measuring", "There is nothing round under the pointer")},
    {Catch::Copper,
     2,
     {QT_TRANSLATE_NOOP("ui::Measuring", "Click where the net path begins"),
      QT_TRANSLATE_NOOP("ui::Measuring", "Click where it ends, on copper of the same net")},
     QT_TRANSLATE_NOOP("ui::Measuring", "There is no copper of a net under the pointer")},
};

}  // namespace

const ToolFacts& factsOf(MeasureFeature::Tool tool) {
    return kTools[static_cast<std::size_t>(tool)];
}

}  // namespace ui
