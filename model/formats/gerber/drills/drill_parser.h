#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "model/formats/gerber/drills/drill_file.h"
#include "model/formats/gerber/image/attributes.h"

namespace model::gerber {

/// The values of one record: X1.5Y2G85X3 gives X, Y, G, X in turn.
struct DrillValue {
    char letter = 0;
    std::string_view digits;
};
using DrillValues = std::vector<DrillValue>;

/// Reads one drill file from its first to its last line. One use.
class DrillParser {
public:
    DrillParser(std::string_view path, const CoordinateFormat& format);

    [[nodiscard]] Image run(std::string_view text);

private:
    struct Tool {
        std::int32_t symbol = formats::kNoRow;  ///< once it has drilled
        std::int32_t attributes = formats::kNoRow;
        double size = 0.0;       ///< nm; 0 not said
        bool isDefined = false;  ///< by a record, not by a comment alone
        Plating plating = Plating::NotSaid;
    };
    /// What a record says of a place and the way there.
    struct Target {
        std::optional<double> x;
        std::optional<double> y;
        std::optional<double> radius;
        std::optional<double> i;
        std::optional<double> j;
        bool isSlot = false;   ///< G85; its other end is m_slotStart
        bool isCycle = false;  ///< a canned cycle that is not read
        bool lifts = false;    ///< the tool, once it is there
        [[nodiscard]] bool hasPlace() const { return x || y; }
        [[nodiscard]] bool hasCentre() const { return i || j; }
    };
    /// What R repeats.
    enum class Last : std::uint8_t { Nothing, Hole, Slot, Path };

    // records: drill_parser.cpp
    void line(std::string_view text);
    void comment(std::string_view text);
    void sizeInComment(std::string_view text);
    [[nodiscard]] bool changesTool();
    void reportRest(std::string_view text, std::uint32_t line);
    void record(std::string_view text);
    void checkUnit(std::string_view text);
    void scaleTools(double factor);
    [[nodiscard]] const DrillValues& values(std::string_view text);
    [[nodiscard]] double length(std::string_view digits);
    void words(const DrillValues& parts);
    void word(const DrillValue& part, const DrillValues& parts, Target& target);
    void beginSlot(Target& target);
    void code(std::string_view digits, const DrillValues& parts, Target& target);
    void misc(std::string_view digits, const DrillValues& parts, Target& target);
    void setOrigin(const DrillValues& parts);
    void tool(const DrillValues& parts);
    void define(int number, double size);
    [[nodiscard]] formats::DrawnFeature attributed(const Tool& tool);

    // holes: drill_holes.cpp
    void moveTo(std::optional<double> x, std::optional<double> y);
    void operate(const Target& target);
    void route(PointD from, const Target& target);
    void plunge();
    void drillPlunge();
    void lift();
    [[nodiscard]] std::optional<PointD> centreOf(PointD from, const Target& target);
    [[nodiscard]] std::optional<PointD> centreOfRadius(PointD from, double radius);
    void add(formats::DrawnKind kind, PointD a, PointD b, PointD centre);
    void use(Tool& tool);
    void repeat(const DrillValues& parts);
    [[nodiscard]] bool mayRepeat(std::size_t count);
    void repeatPattern(const DrillValues& parts);
    void listTool(int number, const Tool& tool);
    void finishTools();

    void report(Severity severity, std::string_view text) {
        m_image.diagnostics.report(severity, m_path, m_line, text);
    }

    std::string_view m_path;
    CoordinateFormat m_format;
    Image m_image;
    AttributeState m_attributes;
    std::map<int, Tool> m_tools;
    DrillValues m_values;
    std::uint32_t m_line = 0;
    int m_tool = 0;
    Plating m_section = Plating::NotSaid;
    std::optional<bool> m_isInch;
    bool m_isInHeader = false;
    bool m_hasPlunges = false;
    bool m_isToolChangedByStop = false;  ///< no record selects a tool: M00 stops the machine for the next one
    bool m_isRouting = false;
    bool m_isDown = false;
    bool m_isPlungeOpen = false;  ///< the tool went down and has not moved since
    bool m_isIncremental = false;
    bool m_isDone = false;
    bool m_isBad = false;
    bool m_isConsumed = false;  ///< the numbers of the record are no place
    int m_motion = 0;
    Last m_last = Last::Nothing;
    PointD m_position;
    PointD m_slotStart;
    PointD m_origin;
    double m_ignored = 0.0;
    std::size_t m_patternBegin = 0;
    std::size_t m_patternEnd = 0;
    std::size_t m_repeated = 0;
};

}  // namespace model::gerber
