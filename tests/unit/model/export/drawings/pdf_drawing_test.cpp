#include "model/export/drawings/pdf_drawing.h"

#include <QRegularExpression>
#include <QtEndian>
#include <QtTest>
#include <sstream>

#include "model/base/parallel.h"
#include "model/export/drawings/pdf_file.h"
#include "tests/unit/model/export/drawings/drawn_board.h"

using model::PdfPages;

namespace {

/// The objects of a file as its table lists them.
struct Pdf {
    std::vector<std::string> objects;  ///< from the number on
    std::string trailer;

    explicit Pdf(const std::string& text) {
        const std::size_t start = text.rfind("startxref\n") + 10;
        std::istringstream table(text.substr(std::stoul(text.substr(start))));
        std::string word;
        std::size_t first = 0;
        std::size_t count = 0;
        table >> word >> first >> count;
        if (word != "xref" || first != 0 || !text.starts_with("%PDF-1.5\n") || !text.ends_with("%%EOF\n")) {
            qFatal("no table of objects");
        }
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t at = 0;
            std::string generation, use;
            table >> at >> generation >> use;
            if (i > 0) {
                objects.push_back(text.substr(at, text.find("\nendobj\n", at) - at));
            }
        }
        trailer = text.substr(text.rfind("trailer"));
    }

    [[nodiscard]] std::size_t count(const std::string& what) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(objects, [&](const std::string& o) { return o.find(what) != std::string::npos; }));
    }
    [[nodiscard]] std::string object(const std::string& what) const {
        const auto found =
            std::ranges::find_if(objects, [&](const std::string& o) { return o.find(what) != std::string::npos; });
        return found == objects.end() ? "" : *found;
    }

    /// What streams hold, in the order of their numbers.
    [[nodiscard]] std::vector<std::string> streams() const {
        std::vector<std::string> all;
        for (const std::string& object : objects) {
            const std::size_t at = object.find("stream\n");
            if (at == std::string::npos) {
                continue;
            }
            const std::size_t length = object.size() - at - 7 - std::string("\nendstream").size();
            const std::size_t stated = object.find("/Length ") + 8;
            const std::string& lengthObject = objects[std::stoul(object.substr(stated)) - 1];
            if (std::stoul(lengthObject.substr(lengthObject.find("obj\n") + 4)) != length) {
                qFatal("the length of a stream is wrong");
            }
            QByteArray packed(4, '\0');
            qToBigEndian<quint32>(1'000'000, packed.data());
            packed += QByteArray(object.data() + at + 7, static_cast<qsizetype>(length));
            all.push_back(qUncompress(packed).toStdString());
        }
        return all;
    }
};

Pdf pdfOf(const model::Document& board, const model::DrawingOptions& options, PdfPages pages) {
    return Pdf(drawn_board::written([&](model::FileWriter& file, base::Progress& progress) {
        return writePdf(board, options, pages, file, progress);
    }));
}

/// The area that the filled paths of a stream cover in mm²: exact, curves included.
double areaOf(const std::string& stream) {
    std::istringstream in(stream);
    std::vector<double> numbers;
    std::string word;
    double area = 0.0, x = 0.0, y = 0.0, startX = 0.0, startY = 0.0;
    const auto go = [&](double toX, double toY) {
        area += drawn_board::underChord(x, y, toX, toY);
        x = toX;
        y = toY;
    };
    while (in >> word) {
        if (word == "m") {
            startX = x = numbers[0];
            startY = y = numbers[1];
        } else if (word == "l") {
            go(numbers[0], numbers[1]);
        } else if (word == "h") {
            go(startX, startY);
        } else if (word == "c") {
            const double fromX = x, fromY = y;
            for (int i = 1; i <= 500; ++i) {
                const double t = i / 500.0, u = 1 - t;
                go(u * u * u * fromX + 3 * u * u * t * numbers[0] + 3 * u * t * t * numbers[2] + t * t * t * numbers[4],
                   u * u * u * fromY + 3 * u * u * t * numbers[1] + 3 * u * t * t * numbers[3] +
                       t * t * t * numbers[5]);
            }
        }
        const bool isNumber = word.find_first_not_of("-.0123456789") == std::string::npos;
        if (isNumber) {
            numbers.push_back(std::stod(word));
        } else {
            numbers.clear();
        }
    }
    return area;
}

bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-3;
}

}  // namespace

class PdfDrawingTest : public QObject {
    Q_OBJECT

private slots:
    void aPagePerLayerInItsOrder() {
        const Pdf pdf = pdfOf(*drawn_board::board(), {}, PdfPages::OnePerLayer);
        QCOMPARE(pdf.count("/Type /Page "), std::size_t{4});
        // 62 by 42 mm, and 6 for the caption.
        QCOMPARE(pdf.count("/MediaBox [0 0 175.748031 136.062992]"), std::size_t{4});
        const std::vector<std::string> streams = pdf.streams();
        QCOMPARE(streams.size(), std::size_t{5});
        QVERIFY(isNear(areaOf(streams[0]), drawn_board::kTop));
        QVERIFY(isNear(areaOf(streams[1]), drawn_board::kBottom));
        QVERIFY(isNear(areaOf(streams[2]), 1.25 * std::numbers::pi));
        QVERIFY(streams[3].find("S\n") != std::string::npos && streams[3].find("f*") == std::string::npos);
        QVERIFY(streams[0].find("2.834645669291 0 0 2.834645669291 0 0 cm") == 0);
        QVERIFY(streams[0].find("\n5 11 m\n") != std::string::npos);  // the disc at (3, 4) mm, from its right end
        QCOMPARE(pdf.count("/Dest ["), std::size_t{4});
        QVERIFY(pdf.object("/Type /Outlines").find("/Count 4") != std::string::npos);
    }

    void pagesSayWhatTheyAreAndHaveTheOutline() {
        const Pdf pdf = pdfOf(*drawn_board::board(), {}, PdfPages::OnePerLayer);
        const std::vector<std::string> streams = pdf.streams();
        QVERIFY(streams[0].find(model::pdfLatin("top <1>, job & co, seen from the top, 1:1") + " Tj") !=
                std::string::npos);
        QCOMPARE(pdf.count("/Font << /Caption "), std::size_t{4});
        QCOMPARE(pdf.count("/XObject << /Outline "), std::size_t{4});
        for (const std::size_t layer : {0, 1, 2}) {
            QVERIFY(streams[layer].find("/Outline Do") != std::string::npos);
        }
        QVERIFY(streams[3].find("/Outline Do") == std::string::npos);
        QVERIFY(streams[4].ends_with("S\n") && streams[3].find(streams[4]) != std::string::npos);
        model::DrawingOptions alone;
        alone.hasOutline = false;
        const Pdf without = pdfOf(*drawn_board::board(), alone, PdfPages::OnePerLayer);
        QCOMPARE(without.count("/XObject <<"), std::size_t{0});
        QVERIFY(without.streams()[0].find("/Outline Do") == std::string::npos);
    }

    void layersOfTheBottomAreMirroredWhereThatIsWanted() {
        const Pdf pdf = pdfOf(*drawn_board::board(), {}, PdfPages::BottomMirrored);
        const std::vector<std::string> streams = pdf.streams();
        for (const std::size_t layer : {0, 1, 2, 3}) {
            const bool isOfBottom = layer == 1;
            QCOMPARE(streams[layer].find("q -1 0 0 1 62 0 cm\n") != std::string::npos, isOfBottom);
            QCOMPARE(streams[layer].find("/Outline Do\nQ\nBT") != std::string::npos, isOfBottom);
        }
        QVERIFY(streams[1].find(model::pdfLatin("bottom, job & co, seen from the bottom, 1:1")) != std::string::npos);
    }

    void onLayersOfOutlinesOnlyAreasAreContours() {
        model::DrawingOptions options;
        options.colours = {0xFF0000};
        const std::string stream = pdfOf(*drawn_board::boardOfOutlines(), options, PdfPages::AllOnOne).streams()[0];
        QVERIFY(stream.find("BDC\n1 0 0 rg\n1 0 0 RG\n") != std::string::npos);
        const std::size_t contour = stream.rfind("f*\n") + 3;
        QCOMPARE(QString::fromStdString(stream).count("f*\n"), 2);
        QVERIFY(isNear(areaOf(stream.substr(0, contour)), drawn_board::kTrack + drawn_board::kDisc));
        QVERIFY(isNear(areaOf(stream.substr(contour)), 400.0) && stream.ends_with("S\nEMC\n"));
    }

    /// R1 is as large as print on boards, U<10> as its body has room; on a mirrored page letters are mirrored back.
    void bodiesHaveTheirDesignators() {
        model::DrawingOptions options;
        options.hasOutline = false;
        const auto has = [&](PdfPages pages, const std::string& letters) {
            const Pdf pdf = pdfOf(*drawn_board::boardOfBodies(), options, pages);
            return pdf.streams()[0].find(letters + " Tj ET\n") != std::string::npos &&
                   pdf.count("/Font << /Caption ") == 1;
        };
        const std::string wide = model::pdfLatin("R1");
        const std::string tall = model::pdfLatin("U<10>");
        // From the corner of the page, 1 mm beside the bodies; pages with captions have 6 mm more below.
        QVERIFY(has(PdfPages::AllOnOne, "BT /Caption 1.4 Tf 1 0 0 1 2.16 1.496 Tm " + wide));
        QVERIFY(has(PdfPages::OnePerLayer, "BT /Caption 1.4 Tf 1 0 0 1 2.16 7.496 Tm " + wide));
        QVERIFY(has(PdfPages::OnePerLayer, "BT /Caption 0.7 Tf 0 1 -1 0 11.752 9.95 Tm " + tall));
        QVERIFY(has(PdfPages::BottomMirrored, "BT /Caption 1.4 Tf -1 0 0 1 3.84 7.496 Tm " + wide));
        QVERIFY(has(PdfPages::BottomMirrored, "BT /Caption 0.7 Tf 0 1 1 0 11.248 9.95 Tm " + tall));
        QCOMPARE(QString::fromStdString(pdfOf(*drawn_board::boardOfBodies(), options, PdfPages::AllOnOne).streams()[0])
                     .count(" Tj ET"),
                 2);
    }

    void captionsAreOfLatinLetters() {
        QCOMPARE(model::pdfLatin("A\xC3\xA4(\\"), std::string("<41E4285C>"));
        QCOMPARE(model::pdfLatin("\xE2\x84\xA6\xFF"), std::string("<3F3F>"));
    }

    void allLayersOnOnePage() {
        model::DrawingOptions options;
        options.colours = {0xFF0000, 0x0000FF};
        const Pdf pdf = pdfOf(*drawn_board::board(), options, PdfPages::AllOnOne);
        QCOMPARE(pdf.count("/Type /Page "), std::size_t{1});
        const std::vector<std::string> streams = pdf.streams();
        QCOMPARE(streams.size(), std::size_t{1});
        const std::size_t blue = streams[0].find("/OC /L1 BDC\n0 0 1 rg\n");
        const std::size_t red = streams[0].find("/OC /L2 BDC\n1 0 0 rg\n");
        QVERIFY(blue != std::string::npos && red != std::string::npos && blue < red);  // the lowest first
        QCOMPARE(pdf.count("/Type /OCG"), std::size_t{4});
        QVERIFY(pdf.object("/Type /Catalog").find("/OCGs [") != std::string::npos);
        QVERIFY(pdf.object("/Type /OCG /Name " + model::pdfText("top <1>")) != "");
        QVERIFY(pdf.object("/Title " + model::pdfText("job & co")) != "");
    }

    /// More than is compressed at a time.
    void longContentsAreWhole() {
        model::DocumentBuilder builder;
        builder.beginLayer(hand_made::addLayer(builder, "top"));
        for (int i = 0; i < 1'000; ++i) {
            builder.addLine({{}, {100 * hand_made::kMm, 0}, hand_made::kMm}, {});
        }
        const std::string content = pdfOf(*builder.finish(), {}, PdfPages::AllOnOne).streams()[0];
        QVERIFY(content.size() > 4 * 65536);
        QVERIFY(isNear(areaOf(content) / 1'000, 100.0 + std::numbers::pi / 4));
    }

    /// More elements than are drawn at once, each of its own size, and some without any.
    void theSameBitsWithAnyNumberOfThreads() {
        model::DocumentBuilder builder;
        builder.beginLayer(hand_made::addLayer(builder, "top"));
        for (int i = 0; i < 20'000; ++i) {
            builder.addCircle({{i * hand_made::kUm, 0}, i % 7 == 0 ? 0 : 1'000 + i, 0}, {});
        }
        const auto board = builder.finish();
        std::vector<std::uint32_t> notDrawn;
        const auto drawn = [&] {
            return drawn_board::written([&](model::FileWriter& file, base::Progress& progress) {
                auto report = model::writePdf(*board, {}, PdfPages::AllOnOne, file, progress);
                for (const model::NotDrawn& one : report->notDrawn) {
                    notDrawn.push_back(static_cast<std::uint32_t>(one.element.row()));
                }
                return report;
            });
        };
        const std::string many = drawn();
        const base::ThreadLimit one(1);
        QVERIFY(drawn() == many);
        QCOMPARE(notDrawn.size(), std::size_t{2} * (20'000 / 7 + 1));
        QVERIFY(std::equal(notDrawn.begin(), notDrawn.begin() + notDrawn.size() / 2,
                           notDrawn.begin() + notDrawn.size() / 2, notDrawn.end()));
        QVERIFY(std::is_sorted(notDrawn.begin(), notDrawn.begin() + notDrawn.size() / 2));
    }

    void textsAreUtf16() {
        QCOMPARE(model::pdfText("A\xC2\xB5"), std::string("<FEFF004100B5>"));
        QCOMPARE(model::pdfText("\xF0\x9F\x98\x80"), std::string("<FEFFD83DDE00>"));
        QCOMPARE(model::pdfText("\xFF"), std::string("<FEFFFFFD>"));
    }

    void failuresLeaveNothing() {
        for (const PdfPages pages : {PdfPages::AllOnOne, PdfPages::OnePerLayer}) {
            drawn_board::checkFailures(
                [&](const model::Document& board, const model::DrawingOptions& options, model::FileWriter& file,
                    base::Progress& progress) { return model::writePdf(board, options, pages, file, progress); });
        }
    }
};

QTEST_GUILESS_MAIN(PdfDrawingTest)
#include "pdf_drawing_test.moc"
