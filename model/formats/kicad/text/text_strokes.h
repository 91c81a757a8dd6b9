#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/base/point.h"

namespace model::kicad {

using base::PointD;

/// How a text of KiCad looks; lengths in nanometres.
struct TextStyle {
    double height = 1e6;  ///< of capitals
    double width = 1e6;   ///< of the same grid sideways
    double pen = 0.0;
    double across = 0.5;  ///< where the anchor is: 0 left, 0.5 middle, 1 right
    double up = 0.5;      ///< 0 bottom, 1 top
    double lineSpacing = 1.0;
    bool isMirrored = false;
    bool isItalic = false;
};

/// How wide a line of a text is, its pen left out.
[[nodiscard]] double widthOf(std::string_view line, const TextStyle& style);
/// The text with line ends where its words would not fit into a width; words that do not fit alone stay as they are.
[[nodiscard]] std::string wrapped(std::string_view text, const TextStyle& style, double width);

/// The strokes of a text, the anchor at the origin, y up, placed as KiCad places them: lines 1.61 heights apart, times
/// their spacing, the first one counting 1.17; anchors at the left or right are 1/1.52 pens from the text. ~{…} has a
/// bar above, ^{…} and _{…} are raised and lowered.
class TextStrokes {
public:
    TextStrokes(std::string_view text, const TextStyle& style);

    [[nodiscard]] const std::vector<std::pair<PointD, PointD>>& strokes() const { return m_strokes; }
    /// Does the font lack one of its characters? Those leave a space.
    [[nodiscard]] bool lacksCharacters() const { return m_lacksCharacters; }
    /// The box around the lines of its pens; min above max if there are none.
    [[nodiscard]] PointD min() const { return m_min; }
    [[nodiscard]] PointD max() const { return m_max; }

    /// Characters of a line between marks.
    struct Run {
        std::u32string characters;
        double scale = 1.0;
        double raised = 0.0;  ///< in heights
        bool hasBar = false;
    };

private:
    void addLine(std::string_view line, double baseLine);
    void addRun(const Run& run, double& cursor, double baseLine);
    void add(PointD a, PointD b);

    const TextStyle& m_style;
    std::vector<std::pair<PointD, PointD>> m_strokes;
    bool m_lacksCharacters = false;
    PointD m_min{1e12, 1e12};
    PointD m_max{-1e12, -1e12};
};

}  // namespace model::kicad
