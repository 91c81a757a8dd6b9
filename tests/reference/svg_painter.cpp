#include "tests/reference/svg_painter.h"

#include <QRegularExpression>
#include <QXmlStreamReader>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace reference {

namespace {

constexpr double kPixel = 25.4 / 72;         // mm
constexpr int kChords = 64;                  // of a curve: within 0.03 % of its size
constexpr double kRounding = 0.02 * kPixel;  // paths are written in steps of 1/256 of a pixel

/// The arc that a curve stands for. cairo writes an arc of `turn` radians as a cubic curve with handles of
/// 4/3 tan(turn / 4) radii, and gerbv lets it be a pixel off: full circles are two curves, bulged by 1.8 % of the
/// radius. False for curves of any other form.
bool appendCurve(Contour& part, Point b, Point c, Point d) {
    const Point a = part.back();
    const Point chord{d.x - a.x, d.y - a.y};
    const Point handle{b.x - a.x, b.y - a.y};
    const double length = std::hypot(chord.x, chord.y);
    const double half = std::atan2(handle.x * chord.y - handle.y * chord.x, handle.x * chord.x + handle.y * chord.y);
    const double radius = length / 2 / std::sin(std::abs(half));
    const double reach = 4.0 / 3.0 * std::tan(std::abs(half) / 2) * radius;
    if (std::abs(std::hypot(handle.x, handle.y) - reach) > kRounding ||
        std::abs(std::hypot(d.x - c.x, d.y - c.y) - reach) > kRounding) {
        return false;
    }
    const double side = half > 0 ? 1 : -1;  // of the middle, as seen along the handle
    const double scale = side * radius / std::hypot(handle.x, handle.y);
    const Point middle{a.x - handle.y * scale, a.y + handle.x * scale};
    for (int i = 1; i <= kChords; ++i) {
        const double turn = 2 * half * i / kChords;
        const Point arm{a.x - middle.x, a.y - middle.y};
        part.push_back({middle.x + arm.x * std::cos(turn) - arm.y * std::sin(turn),
                        middle.y + arm.x * std::sin(turn) + arm.y * std::cos(turn)});
    }
    return true;
}

using Matrix = std::array<double, 6>;

/// matrix(a, b, c, d, e, f); unit matrix where there is none.
Matrix matrixOf(const QString& text, bool& isGood) {
    if (text.isEmpty()) {
        return {1, 0, 0, 1, 0, 0};
    }
    static const QRegularExpression form(R"(^matrix\(([^)]*)\)$)");
    const QStringList numbers = form.match(text).captured(1).split(',');
    isGood = isGood && numbers.size() == 6;
    Matrix matrix{1, 0, 0, 1, 0, 0};
    for (std::size_t i = 0; i < 6 && isGood; ++i) {
        matrix[i] = numbers[static_cast<qsizetype>(i)].toDouble();
    }
    return matrix;
}

/// The parts of a path, laid on the board: each a list of points, curves as chords of arcs.
std::vector<Contour> pathOf(const QString& data, const Matrix& m, bool& isGood) {
    std::vector<Contour> parts;
    const QStringList words = data.split(' ', Qt::SkipEmptyParts);
    qsizetype at = 0;
    const auto point = [&] {
        isGood = isGood && at + 1 < words.size();
        const Point p = isGood ? Point{words[at].toDouble(), words[at + 1].toDouble()} : Point{};
        at += 2;
        return Point{(m[0] * p.x + m[2] * p.y + m[4]) * kPixel, -(m[1] * p.x + m[3] * p.y + m[5]) * kPixel};
    };
    while (at < words.size() && isGood) {
        const QString command = words[at++];
        isGood = command == "M" || command == "Z" || (!parts.empty() && (command == "L" || command == "C"));
        if (command == "M") {
            parts.push_back({point()});
        } else if (command == "L") {
            parts.back().push_back(point());
        } else if (command == "Z" && !parts.empty()) {
            parts.back().push_back(parts.back().front());
        } else if (command == "C" && isGood) {
            const Point b = point();
            const Point c = point();
            const Point d = point();
            isGood = isGood && appendCurve(parts.back(), b, c, d);
        }
    }
    return parts;
}

/// The rectangle along a line, without ends.
Contour bar(Point a, Point b, double width) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point side{(a.y - b.y) / length * width / 2, (b.x - a.x) / length * width / 2};
    return {{a.x - side.x, a.y - side.y},
            {b.x - side.x, b.y - side.y},
            {b.x + side.x, b.y + side.y},
            {a.x + side.x, a.y + side.y}};
}

std::vector<Contour> strokeOf(const std::vector<Contour>& parts, double width, bool isRound) {
    std::vector<Contour> pieces;
    for (const Contour& part : parts) {
        for (std::size_t i = 0; i + 1 < part.size(); ++i) {
            const bool isPoint = part[i].x == part[i + 1].x && part[i].y == part[i + 1].y;
            if (isRound) {
                const std::vector<Contour> piece = lineTrack(part[i], part[i + 1], width);
                pieces.insert(pieces.end(), piece.begin(), piece.end());
            } else if (!isPoint) {
                pieces.push_back(bar(part[i], part[i + 1], width));
            }
        }
    }
    return pieces;
}

}  // namespace

class SvgPicture::Reader {
public:
    Reader(SvgPicture& picture, std::string_view svg)
        : m_picture(picture), m_xml(QByteArray(svg.data(), static_cast<qsizetype>(svg.size()))) {}

    void run() {
        while (!m_xml.atEnd()) {
            const auto token = m_xml.readNext();
            if (token == QXmlStreamReader::StartElement) {
                begin(m_xml.name().toString());
            } else if (token == QXmlStreamReader::EndElement && m_xml.name() == QString("g")) {
                m_group.clear();
            }
        }
        if (m_xml.hasError()) {
            unknown(m_xml.errorString());
        }
    }

private:
    void unknown(const QString& what) { m_picture.m_unknown.push_back(what.toStdString()); }
    [[nodiscard]] QString value(const char* name) const { return m_xml.attributes().value(name).toString(); }
    [[nodiscard]] std::vector<Shape>& shapes() { return m_group.isEmpty() ? m_picture.m_shapes : m_groups[m_group]; }

    void begin(const QString& name) {
        if (name == "path") {
            path();
        } else if (name == "g") {
            m_group = value("id");
        } else if (name == "use") {
            use();
        } else if (name != "svg" && name != "defs" && name != "clipPath" && name != "rect") {
            unknown(name);  // clips are the whole picture
        }
    }

    /// Groups lie where they are drawn; their matrices are rounding.
    void use() {
        bool isGood = true;
        const Matrix m = matrixOf(value("transform"), isGood);
        const bool isPlain = isGood && m[0] == 1 && m[1] == 0 && m[2] == 0 && m[3] == 1 && std::abs(m[4]) < 1e-9 &&
                             std::abs(m[5]) < 1e-9;
        const auto group =
            m_groups.find(m_xml.attributes().value("http://www.w3.org/1999/xlink", "href").mid(1).toString());
        if (!isPlain || group == m_groups.end()) {
            return unknown("use");
        }
        shapes().insert(shapes().end(), group->second.begin(), group->second.end());
    }

    void path() {
        const bool isFilled = value("fill") != "none";
        if (m_xml.attributes().isEmpty() || value("fill").isEmpty()) {
            return;  // the outline of a clip
        }
        const QString colour = value(isFilled ? "fill" : "stroke");
        const bool isWhite = colour == "rgb(100%, 100%, 100%)";
        bool isGood = isWhite || colour == "rgb(78.431373%, 45.882353%, 20%)";
        const Matrix matrix = matrixOf(value("transform"), isGood);
        std::vector<Contour> parts = pathOf(value("d"), matrix, isGood);
        if (!isFilled) {
            const double width = value("stroke-width").toDouble() * std::hypot(matrix[0], matrix[1]) * kPixel;
            parts = strokeOf(parts, width, value("stroke-linecap") == "round");
            std::ranges::transform(parts, parts.begin(), [](const Contour& piece) { return wound(piece, false); });
        }
        if (!isGood) {
            return unknown("path " + value("d").left(40));
        }
        shapes().push_back({std::move(parts), !isWhite, isFilled ? Raster::Rule::EvenOdd : Raster::Rule::Winding});
    }

    SvgPicture& m_picture;
    QXmlStreamReader m_xml;
    QString m_group;
    std::map<QString, std::vector<Shape>> m_groups;
};

SvgPicture::SvgPicture(std::string_view svg) {
    Reader(*this, svg).run();
}

void SvgPicture::paint(Raster& raster, Point shift) const {
    for (const Shape& shape : m_shapes) {
        std::vector<Contour> contours = shape.contours;
        for (Contour& contour : contours) {
            std::ranges::transform(contour, contour.begin(), [&](Point p) {
                return Point{p.x + shift.x, p.y + shift.y};
            });
        }
        raster.fill(contours, shape.isDark, shape.rule);
    }
}

std::pair<Point, Point> SvgPicture::corners() const {
    Point low{1e9, 1e9};
    Point high{-1e9, -1e9};
    for (const Shape& shape : m_shapes) {
        for (const Contour& contour : shape.contours) {
            for (const Point p : contour) {
                if (shape.isDark) {
                    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
                }
            }
        }
    }
    return {low, high};
}

}  // namespace reference
