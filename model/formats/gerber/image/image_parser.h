#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/formats/gerber/image/apertures.h"
#include "model/formats/gerber/image/attributes.h"
#include "model/formats/gerber/image/coordinates.h"
#include "model/formats/gerber/image/image.h"
#include "model/formats/gerber/image/transform.h"

namespace model::gerber {

/// Reads one file from its first to its last command. Words (`X…Y…D01*`) are taken apart where they stand, without
/// copies: they are nearly all of a file.
class ImageParser {
public:
    ImageParser(std::string_view text, std::string_view path, base::PointD shift);

    [[nodiscard]] Image run();

private:
    /// A shape that D10 and above select.
    struct Aperture {
        std::int32_t symbol = formats::kNoRow;
        std::int32_t block = formats::kNoRow;
        std::int32_t attributes = formats::kNoRow;
    };
    /// A block (AB) or a repeated step (SR) that is being written.
    struct Frame {
        bool isBlock = false;
        int aperture = 0;
        int nx = 1;
        int ny = 1;
        double dx = 0.0;
        double dy = 0.0;
        std::int32_t attributes = formats::kNoRow;
        std::vector<formats::DrawnFeature> features;
    };
    /// The data of one word.
    struct Word {
        bool hasX = false;
        bool hasY = false;
        bool hasData = false;
        double x = 0.0;
        double y = 0.0;
        double i = 0.0;
        double j = 0.0;
        int operation = 0;
    };
    enum class Mode : std::uint8_t { Linear, Clockwise, CounterClockwise };

    // words: image_parser.cpp
    void skipBlanks();
    void word();
    void comment();
    void endWord(const Word& word);
    [[nodiscard]] double readLength();
    [[nodiscard]] int readInteger();
    void gCode(int code);
    void mCode(int code);
    void reportRest();
    void select(int code);

    // objects: image_objects.cpp
    void operate(const Word& read);
    [[nodiscard]] Word onImage(Word word) const;
    [[nodiscard]] bool isClockwise() const;
    void noteBeyond(base::PointD place);
    void draw(Point to, const Word& word);
    void flash();
    void flashBlock(const Aperture& aperture);
    [[nodiscard]] bool findCentre(Point to, const Word& word, Point& centre);
    [[nodiscard]] Point centreOf(Point to, const Word& word);
    [[nodiscard]] bool isAbout(Point centre, Point to) const;
    [[nodiscard]] Point singleQuadrantCentre(Point to, const Word& word) const;
    void beginRegion();
    void endRegion();
    void endContour();
    void add(formats::DrawnFeature feature);
    [[nodiscard]] std::vector<formats::DrawnFeature>& sink();
    [[nodiscard]] bool mayExpand(std::size_t count);
    void endFrame();
    void repeatFrame(const Frame& frame);
    void addMoved(const std::vector<formats::DrawnFeature>& features, Point by);
    void finish();

    // commands between %: image_commands.cpp
    void extended();
    void command(std::string_view text);
    [[nodiscard]] bool parameter(std::string_view code, std::string_view rest);
    [[nodiscard]] bool imageParameter(std::string_view code, std::string_view rest);
    void checkFormat(std::string_view code, std::string_view rest);
    [[nodiscard]] bool transformImage(std::string_view code, std::string_view rest);
    void macro(std::string_view text);
    void define(std::string_view rest);
    void block(std::string_view rest);
    void repeat(std::string_view rest);
    void report(Severity severity, std::string_view text) {
        m_image.diagnostics.report(severity, m_path, m_line, text);
    }

    const char* m_at;
    const char* m_end;
    std::string_view m_path;
    std::uint32_t m_line = 1;
    Image m_image;
    AttributeState m_attributes;
    Mover m_mover;
    CoordinateFormat m_format;

    std::map<std::string, Macro, std::less<>> m_macros;
    std::unordered_map<int, Aperture> m_apertures;
    std::vector<std::vector<formats::DrawnFeature>> m_blocks;
    std::vector<Frame> m_frames;
    std::size_t m_expanded = 0;  ///< objects that came from blocks and repeated steps

    Mode m_mode = Mode::Linear;
    bool m_isSingleQuadrant = false;
    bool m_hasQuadrant = false;  ///< G74 or G75 was there
    bool m_isClear = false;
    bool m_isMirroredX = false;
    bool m_isMirroredY = false;
    double m_rotation = 0.0;
    double m_scale = 1.0;
    Transform m_flashed;  ///< LM, LR and LS together
    const Aperture* m_aperture = nullptr;
    int m_selected = 0;
    int m_lastOperation = 0;
    Point m_position;
    bool m_isBad = false;  ///< the position is beyond the largest coordinate
    bool m_isInRegion = false;
    std::uint32_t m_contourLine = 0;
    std::vector<PathNode> m_contour;  ///< the last one is where it stands
    bool m_isDone = false;

    // of the image as a whole, all outdated
    Point m_imageOffset;
    bool m_isImageMirroredA = false;
    bool m_isImageMirroredB = false;
    double m_imageScale = 1.0;
    bool m_isAxesSwapped = false;
    double m_imageRotation = 0.0;
};

}  // namespace model::gerber
