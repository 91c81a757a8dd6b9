#include "tests/reference/odb_painter.h"

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "tests/reference/symbols.h"

namespace reference {

/// The head of a features file.
struct OdbPainter::File {
    double mm = 25.4;  ///< per unit
    struct Name {
        std::string name;
        double unit = 0.0254;
    };
    std::map<int, Name> symbols;
};

namespace {

std::vector<std::string> split(const std::string& line) {
    std::istringstream in(line.substr(0, line.find(';')));
    std::vector<std::string> fields;
    for (std::string field; in >> field;) {
        fields.push_back(field);
    }
    return fields;
}

double unitOf(const std::string& name) {
    return name == "MM" || name == "mm" ? 1.0 : 25.4;
}

}  // namespace

OdbPainter::OdbPainter(ReadFile read) : m_read(std::move(read)) {
    std::istringstream info(m_read("misc/info").value_or(""));
    for (std::string line; std::getline(info, line);) {
        std::erase_if(line, [](char c) { return c == ' ' || c == '\r'; });
        if (line.starts_with("UNITS=") && line.size() > 6) {
            m_defaultUnit = unitOf(line.substr(6));
        }
    }
}

void OdbPainter::paint(const std::string& path, Raster& raster, bool isInverse) {
    paintRecords(m_read(path).value_or(""), {}, raster, isInverse, 0);
}

namespace {

/// From the symbol's system to the board, innermost frame last.
template <class Frames>
Point toBoard(const Frames& frames, Point p) {
    for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) {
        const double a = frame->clockwiseDeg * std::numbers::pi / 180;
        const Point rotated{p.x * std::cos(a) + p.y * std::sin(a), p.y * std::cos(a) - p.x * std::sin(a)};
        p = {frame->location.x + (frame->isMirrored ? -rotated.x : rotated.x), frame->location.y + rotated.y};
    }
    return p;
}

template <class Frames>
Point fromBoard(const Frames& frames, Point p) {
    for (const auto& frame : frames) {
        const Point q{(p.x - frame.location.x) * (frame.isMirrored ? -1 : 1), p.y - frame.location.y};
        const double a = frame.clockwiseDeg * std::numbers::pi / 180;
        p = {q.x * std::cos(a) - q.y * std::sin(a), q.x * std::sin(a) + q.y * std::cos(a)};
    }
    return p;
}

}  // namespace

void OdbPainter::pad(const File& file, const std::vector<std::string>& fields, const std::vector<Frame>& frames,
                     Raster& raster, bool value, int depth) {
    const File::Name& name = file.symbols.at(std::stoi(fields[3]));
    Frame frame;
    frame.location = {std::stod(fields[1]) * file.mm, std::stod(fields[2]) * file.mm};
    const int code = fields.size() > 6 ? std::stoi(fields[6]) : 0;
    frame.isMirrored = code == 9 || (code < 8 && code >= 4);
    frame.clockwiseDeg = code >= 8 ? std::stod(fields[7]) : code % 4 * 90.0;
    std::vector<Frame> inner = frames;
    inner.push_back(frame);
    if (const std::optional<Symbol> symbol = standardSymbol(name.name, name.unit)) {
        return raster.fill(
            toBoard(inner, {0, 0}), symbol->reach, [&](Point p) { return symbol->isInside(fromBoard(inner, p)); },
            value);
    }
    const std::optional<std::string> user = m_read("symbols/" + name.name + "/features");
    if (!user || depth > 4) {
        m_unknown.push_back("symbol " + name.name);
        return;
    }
    paintRecords(*user, inner, raster, !value, depth + 1);
}

void OdbPainter::track(const File& file, const std::vector<std::string>& fields, const std::vector<Frame>& frames,
                       Raster& raster, bool value, bool isArc) {
    const File::Name& name = file.symbols.at(std::stoi(fields[isArc ? 7 : 5]));
    const std::optional<Symbol> symbol = standardSymbol(name.name, name.unit);
    const auto at = [&](std::size_t i) {
        return toBoard(frames, {std::stod(fields[i]) * file.mm, std::stod(fields[i + 1]) * file.mm});
    };
    const bool isSquare = name.name.starts_with("s") || name.name.starts_with("rect");
    if (symbol && symbol->penWidth > 0 && !isArc) {
        raster.fill(lineTrack(at(1), at(3), symbol->penWidth), value);
    } else if (symbol && symbol->penWidth > 0) {
        bool isClockwise = fields.at(10) == "Y";
        for (const Frame& frame : frames) {
            isClockwise = isClockwise != frame.isMirrored;
        }
        raster.fill(arcTrack(at(1), at(3), at(5), isClockwise, symbol->penWidth), value);
    } else if (symbol && isSquare && !isArc && frames.empty()) {
        // What an upright box passes: a point is inside when some place of the box covers it.
        const Point a = at(1);
        const Point b = at(3);
        const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const int steps = static_cast<int>(length / 0.002) + 1;
        raster.fill(
            middle, length / 2 + symbol->reach,
            [&](Point p) {
                for (int i = 0; i <= steps; ++i) {
                    const double t = static_cast<double>(i) / steps;
                    if (symbol->isInside({p.x - a.x - t * (b.x - a.x), p.y - a.y - t * (b.y - a.y)})) {
                        return true;
                    }
                }
                return false;
            },
            value);
    } else if (name.name != "r0") {
        m_unknown.push_back("stroke with " + name.name);
    }
}

void OdbPainter::paintRecords(const std::string& text, const std::vector<Frame>& frames, Raster& raster, bool isInverse,
                              int depth) {
    File file;
    file.mm = m_defaultUnit;
    std::vector<Contour> surface;
    Contour contour;
    bool isHole = false;
    bool surfaceValue = true;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const std::vector<std::string> fields = split(line);
        if (fields.empty() || line[0] == '#') {
            continue;
        }
        const std::string& kind = fields[0];
        const auto point = [&](std::size_t i) {
            return toBoard(frames, {std::stod(fields.at(i)) * file.mm, std::stod(fields.at(i + 1)) * file.mm});
        };
        const auto value = [&](std::size_t i) { return (fields.at(i) == "P") != isInverse; };
        if (kind.starts_with("UNITS=")) {
            file.mm = unitOf(kind.substr(6));
        } else if (kind == "U") {
            file.mm = unitOf(fields.at(1));
        } else if (kind[0] == '$') {
            const double unit = fields.size() > 2 ? (fields[2] == "I" ? 25.4 : 1.0) : file.mm;
            file.symbols[std::stoi(kind.substr(1))] = {fields.at(1), unit / 1000};
        } else if (kind == "L") {
            track(file, fields, frames, raster, value(6), false);
        } else if (kind == "A") {
            track(file, fields, frames, raster, value(8), true);
        } else if (kind == "P") {
            pad(file, fields, frames, raster, value(4), depth);
        } else if (kind == "S") {
            surfaceValue = value(1);
            surface.clear();
        } else if (kind == "OB") {
            contour = {point(1)};
            isHole = fields.at(3) == "H";
        } else if (kind == "OS") {
            contour.push_back(point(1));
        } else if (kind == "OC") {
            bool isClockwise = fields.at(5) == "Y";
            for (const Frame& frame : frames) {
                isClockwise = isClockwise != frame.isMirrored;
            }
            const Point from = contour.back();
            contour.pop_back();
            appendArc(contour, from, point(1), point(3), isClockwise);
            contour.push_back(point(1));
        } else if (kind == "OE") {
            surface.push_back(wound(contour, isHole));
        } else if (kind == "SE") {
            raster.fill(surface, surfaceValue);
        } else if (kind == "T" || kind == "B") {
            m_unknown.push_back(kind);
        }
    }
}

}  // namespace reference
