// Parts of Gerber jobs against KiCad's own file of the same board: pick-and-place tables and X3 component layers as
// KiCad writes them, made here from the footprints of that file, read line by line without the reader of the program.
#include <QRegularExpression>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>

#include "model/text/whole_file.h"
#include "tests/boards/gerber_job.h"
#include "tests/locations.h"

namespace {

namespace fs = std::filesystem;

struct Footprint {
    QString refdes;
    QString name;
    double x = 0.0;  ///< mm, y downwards
    double y = 0.0;
    double degrees = 0.0;
    bool isOnBack = false;
};

/// KiCad 9 writes an item per line, indented by its depth. (That of RoyalBlue54L-Feather is wrong, since parentheses
/// lack: only differences count.)
std::vector<Footprint> footprintsOf(const QString& text) {
    static const QRegularExpression begin(R"re(^\(footprint "(?:[^":]*:)?([^"]*)")re");
    static const QRegularExpression layer(R"re(^\(layer "([^"]*)"\)$)re");
    static const QRegularExpression at(R"(^\(at ([-\d.]+) ([-\d.]+)(?: ([-\d.]+))?\)$)");
    static const QRegularExpression reference(R"re(^\(property "Reference" "([^"]*)")re");
    std::vector<Footprint> footprints;
    qsizetype outside = 0;  // depth of the footprint
    bool isInside = false;
    for (const QString& indented : text.split('\n')) {
        const QString line = indented.trimmed();
        const qsizetype depth = indented.indexOf('(');
        if (const auto found = begin.match(line); found.hasMatch()) {
            footprints.push_back({{}, found.captured(1)});
            isInside = true;
            outside = depth;
        } else if (depth >= 0 && depth <= outside) {
            isInside = false;
        } else if (!isInside || depth != outside + 1) {
            continue;
        } else if (const auto side = layer.match(line); side.hasMatch()) {
            footprints.back().isOnBack = side.captured(1) == "B.Cu";
        } else if (const auto ref = reference.match(line); ref.hasMatch()) {
            footprints.back().refdes = ref.captured(1);
        } else if (const auto place = at.match(line); place.hasMatch()) {
            footprints.back().x = place.captured(1).toDouble();
            footprints.back().y = place.captured(2).toDouble();
            footprints.back().degrees = place.captured(3).toDouble();
        }
    }
    return footprints;
}

/// Those whose name no other has: the rest cannot be told apart in a table.
std::vector<Footprint> withOwnNames(const std::vector<Footprint>& all) {
    std::map<QString, int> count;
    for (const Footprint& one : all) {
        ++count[one.refdes];
    }
    std::vector<Footprint> own;
    std::ranges::copy_if(all, std::back_inserter(own),
                         [&](const Footprint& one) { return !one.refdes.isEmpty() && count[one.refdes] == 1; });
    return own;
}

/// `x0`, `y0`: the origin it counts from, as the drill origin that a board may set.
QString tableOf(const std::vector<Footprint>& footprints, double x0, double y0) {
    QString text = "Ref,Val,Package,PosX,PosY,Rot,Side\n";
    for (const Footprint& one : footprints) {
        text += QString("\"%1\",\"\",\"%2\",%3,%4,%5,%6\n")
                    .arg(one.refdes, one.name)
                    .arg(one.x - x0, 0, 'f', 6)
                    .arg(y0 - one.y, 0, 'f', 6)
                    .arg(one.degrees, 0, 'f', 6)
                    .arg(one.isOnBack ? "bottom" : "top");
    }
    return text;
}

/// What would end an attribute.
QString escaped(QString text) {
    return text.replace('*', "\\u002A").replace('%', "\\u0025").replace(',', "\\u002C");
}

QString componentLayerOf(const std::vector<Footprint>& footprints, bool isBack) {
    QString text = "%TF.FileFunction,Component,L" + QString(isBack ? "2,Bot" : "1,Top") +
                   "*%\n%FSLAX46Y46*%\n%MOMM*%\n%TA.AperFunction,ComponentMain*%\n%ADD10C,0.3*%\n%TD*%\nD10*\n";
    for (const Footprint& one : footprints) {
        if (one.isOnBack == isBack) {
            text += QString("%TO.C,%1*%\n%TO.CRot,%2*%\n%TO.CFtp,%3*%\nX%4Y%5D03*\n%TD*%\n")
                        .arg(escaped(one.refdes))
                        .arg(one.degrees, 0, 'f', 6)
                        .arg(escaped(one.name))
                        .arg(std::llround(one.x * 1e6))
                        .arg(std::llround(-one.y * 1e6));
        }
    }
    return text + "M02*\n";
}

std::map<std::string, const model::Component*> partsOf(const model::Document& board) {
    std::map<std::string, const model::Component*> parts;
    for (const model::Component& part : board.components) {
        parts[part.refdes] = &part;
    }
    return parts;
}

bool isClose(model::Point a, model::Point b) {
    return std::abs(a.x - b.x) <= 1'000 && std::abs(a.y - b.y) <= 1'000;
}

QByteArray textOf(const Footprint& one, const model::Component& part, const model::Component& source) {
    return QString("%1: %2, %3 by %4, in KiCad's file %5, %6 by %7")
        .arg(one.refdes)
        .arg(part.placement.origin.x / 1e6)
        .arg(part.placement.origin.y / 1e6)
        .arg(part.placement.clockwiseDeg)
        .arg(source.placement.origin.x / 1e6)
        .arg(source.placement.origin.y / 1e6)
        .arg(source.placement.clockwiseDeg)
        .toUtf8();
}

}  // namespace

class PlacementBoardsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!fs::exists(locations::boards() / "formats" / "kicad")) {
            QSKIP("the folder of boards holds no formats/kicad");
        }
    }

    void partsLieWhereKicadsFileHasThem_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("form");
        QTest::addColumn<int>("count");
        const std::map<const char*, int> boards = {{"StickHub", 94},
                                                   {"RoyalBlue54L-Feather", 71},
                                                   {"multichannel_mixer", 114},
                                                   {"kit-dev-coldfire-xilinx_5213", 160},
                                                   {"flat_hierarchy", 64},
                                                   {"custom_pads_test", 5}};
        for (const auto& [name, count] : boards) {
            for (const char* form : {"table", "table from another origin", "X3"}) {
                QTest::addRow("%s, %s", name, form) << QString(name) << QString(form) << count;
            }
        }
    }
    void partsLieWhereKicadsFileHasThem() {
        QFETCH(QString, name);
        QFETCH(QString, form);
        QFETCH(int, count);
        const fs::path folder = locations::boards() / "formats" / "kicad" / name.toStdString();
        const fs::path kicad = folder / (name.toStdString() + ".kicad_pcb");
        const auto text = model::readWholeFile(kicad);
        QVERIFY(text.ok());
        const std::vector<Footprint> footprints = withOwnNames(footprintsOf(QString::fromStdString(*text)));
        GerberJob job;
        QVERIFY(job.take(folder / (name.toStdString() + "-gerbers.zip")));
        if (form.startsWith("table")) {
            const bool isShifted = form != "table";
            const QString table = tableOf(footprints, isShifted ? 200.0 : 0.0, isShifted ? 133.25 : 0.0);
            job.write("board-all-pos.csv", table.toStdString());
        } else {
            job.write("board-pnp_top.gbr", componentLayerOf(footprints, false).toStdString());
            job.write("board-pnp_bottom.gbr", componentLayerOf(footprints, true).toStdString());
        }
        base::Progress progress;
        const auto source = model::readBoard(kicad, {}, progress);
        const auto board = job.open();
        QVERIFY(source && board != nullptr);
        const auto theirs = partsOf(**source);
        const auto ours = partsOf(*board);
        for (const Footprint& one : footprints) {
            const auto their = theirs.find(one.refdes.toStdString());
            const auto our = ours.find(one.refdes.toStdString());
            QVERIFY2(their != theirs.end() && our != ours.end(), qPrintable(one.refdes));
            const model::Component& a = *their->second;
            const model::Component& b = *our->second;
            QVERIFY2(isClose(a.placement.origin, b.placement.origin), textOf(one, b, a));
            QCOMPARE(b.side, a.side);
            const double apart = std::abs(std::remainder(a.placement.clockwiseDeg - b.placement.clockwiseDeg, 360.0));
            QVERIFY2(apart < 1e-6, textOf(one, b, a));
        }
        QCOMPARE(static_cast<int>(footprints.size()), count);
    }
};

QTEST_APPLESS_MAIN(PlacementBoardsTest)
#include "placement_boards_test.moc"
