// What a layer map says counts more than names and attributes, and proposals say what would be taken without one.

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <fstream>
#include <map>

#include "model/formats/gerber/layer_map.h"
#include "model/formats/gerber/layer_proposals.h"
#include "model/formats/registry.h"

using model::gerber::FileRole;
using model::gerber::LayerMap;
using model::gerber::LayerProposal;
using Kind = FileRole::Kind;

namespace {

const std::string kHead = "%FSLAX46Y46*%\n%MOMM*%\n";
const std::string kCopper = kHead + "%ADD10C,1.5*%D10*X2000000Y2000000D03*X8000000D03*M02*\n";
constexpr const char* kDrills = "M48\nMETRIC\nT1C0.8\n%\nT1\nX2.0Y2.0\nX8.0Y2.0\nM30\n";

class Job {
public:
    explicit Job(const std::map<std::string, std::string>& files) {
        (void)QDir(m_folder.path()).mkpath("job");
        for (const auto& [name, text] : files) {
            (void)QDir(m_folder.path() + "/job").mkpath(QFileInfo(QString::fromStdString(name)).path());
            write("job/" + name, text);
        }
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream((m_folder.path() + "/").toStdString() + name, std::ios::binary) << text;
    }
    [[nodiscard]] std::string path(const std::string& name = "job") const {
        return (m_folder.path() + "/").toStdString() + name;
    }
    [[nodiscard]] base::Result<std::shared_ptr<const model::Document>> open(const std::string& map = "") const {
        base::Progress progress;
        model::ReadOptions options;
        options.layerMap = map.empty() ? map : path(map);
        return model::readBoard(path(), options, progress);
    }
    [[nodiscard]] std::vector<LayerProposal> propose(const std::string& map = "") const {
        base::Progress progress;
        model::ReadOptions options;
        options.layerMap = map.empty() ? map : path(map);
        auto proposals = model::gerber::proposeLayers(path(), options, progress);
        return proposals ? std::move(*proposals) : std::vector<LayerProposal>();
    }

private:
    QTemporaryDir m_folder;
};

const model::Diagnostic* messageWith(const model::Document& board, const std::string& words) {
    const auto& entries = board.diagnostics.entries();
    const auto found =
        std::ranges::find_if(entries, [&](const auto& entry) { return entry.text.find(words) != std::string::npos; });
    return found == entries.end() ? nullptr : &*found;
}

std::string wordsOf(const std::vector<LayerProposal>& proposals, const std::string& path) {
    const auto found = std::ranges::find(proposals, path, &LayerProposal::path);
    return found == proposals.end() ? "none" : model::gerber::wordsOf(found->role) + (found->isSure ? "" : "?");
}

}  // namespace

class GerberLayerMapTest : public QObject {
    Q_OBJECT

private slots:
    void wordsSayWhatAFileDraws_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("again");
        const std::map<const char*, const char*> rows = {
            {"copper 1", "copper top 1"},
            {"3 Copper negative", "copper inner 3 negative"},
            {"copper bottom 4", "copper bottom 4"},
            {"copper\tbottom", "copper bottom"},
            {"solder-mask top", "solder-mask top"},
            {"paste bottom", "paste bottom"},
            {"silkscreen TOP", "silkscreen top"},
            {"outline", "outline"},
            {"drill", "drill"},
            {"drill non-plated", "drill non-plated"},
            {"plated drill 4-2", "drill plated 2-4"},
            {"rout plated", "rout plated"},
            {"components top", "components top"},
            {"glue bottom", "glue bottom"},
            {"document", "document"},
            {"ignore", "ignore"},
        };
        for (const auto& [words, again] : rows) {
            QTest::newRow(words) << words << again;
        }
    }
    void wordsSayWhatAFileDraws() {
        QFETCH(QString, words);
        QFETCH(QString, again);
        const auto role = model::gerber::roleOfWords(words.toStdString());
        QVERIFY(role.has_value());
        QCOMPARE(QString::fromStdString(model::gerber::wordsOf(*role)), again);
        const auto same = model::gerber::roleOfWords(again.toStdString());
        QVERIFY(same.has_value());
        QCOMPARE(QString::fromStdString(model::gerber::wordsOf(*same)), again);
    }

    void otherWordsAreRefused() {
        for (const char* words : {"", "top", "copper gold", "copper 0", "copper 1000", "copper plated", "paste 2",
                                  "outline 1-2", "solder-mask negative", "copper copper", "drill 1-x", "copper 1-2"}) {
            QVERIFY2(!model::gerber::roleOfWords(words), words);
        }
    }

    void aFileOfAMapIsReadRowByRow() {
        model::Diagnostics diagnostics;
        const LayerMap map = model::gerber::parseLayerMap(
            "# comment\n\n a = b.gbr = copper top \nno words\n\"# x.gbr\" = outline\nbad.gbr = gold\r\nA = B.GBR=paste "
            "top\n",
            "map.txt", diagnostics);
        QCOMPARE(map.rows().size(), std::size_t{2});
        QCOMPARE(map.rows()[0].file, std::string("A = B.GBR"));
        QCOMPARE(map.rows()[0].role.kind, Kind::Paste);
        QCOMPARE(map.rows()[0].line, 7U);
        QCOMPARE(map.rows()[1].file, std::string("# x.gbr"));
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});
        QCOMPARE(diagnostics.entries()[0].line, 4U);
        QCOMPARE(diagnostics.entries()[0].count, 2U);
        const std::string text = model::gerber::layerMapText(map);
        model::Diagnostics none;
        QCOMPARE(model::gerber::layerMapText(model::gerber::parseLayerMap(text, "", none)), text);
        QVERIFY(none.entries().empty());
    }

    void pathsCountMoreThanNames() {
        LayerMap map;
        map.set("top.gbr", *model::gerber::roleOfWords("copper 1"));
        map.set("a/Top.gbr", *model::gerber::roleOfWords("ignore"));
        QCOMPARE(map.find("b/TOP.GBR")->role.kind, Kind::Copper);
        QCOMPARE(map.find("A/TOP.GBR")->role.kind, Kind::Ignored);
        QVERIFY(map.find("bottom.gbr") == nullptr);
    }

    void aMapCountsMoreThanNames() {
        const Job job({{"one.gtl", kCopper},
                       {"two.xyz", kCopper},
                       {"three.gbl", kCopper},
                       {"old.gbs", kCopper},
                       {"thru.drl", kDrills},
                       {"again.drl", kDrills}});
        job.write("map.txt",
                  "one.gtl = copper 3\ntwo.xyz = copper 1\nthree.gbl = copper 2 negative\nold.gbs = ignore\n"
                  "again.drl = drill non-plated 1-2\nthru.drl = drill plated\nnowhere.gbr = paste top\n");
        const auto board = job.open("map.txt");
        QVERIFY(board.ok());
        std::vector<std::string> copper;
        for (const model::Layer& layer : (*board)->layers) {
            if (layer.isCopper()) {
                copper.push_back(layer.name);
            }
        }
        QCOMPARE(copper.size(), std::size_t{3});
        const std::vector<LayerProposal> proposals = job.propose("map.txt");
        QCOMPARE(wordsOf(proposals, "two.xyz"), std::string("copper top 1"));
        QCOMPARE(wordsOf(proposals, "three.gbl"), std::string("copper inner 2 negative"));
        QCOMPARE(wordsOf(proposals, "one.gtl"), std::string("copper bottom 3"));
        QCOMPARE(wordsOf(proposals, "old.gbs"), std::string("ignore"));
        QCOMPARE(std::ranges::count_if((*board)->layers, &model::Layer::isNegative), 1);
        QVERIFY(std::ranges::none_of((*board)->layers,
                                     [](const auto& layer) { return layer.type == model::LayerType::SolderMask; }));
        // Of two files that drill the same holes one would be a document, had the map not said otherwise.
        QCOMPARE(std::ranges::count_if((*board)->layers,
                                       [](const auto& layer) { return layer.type == model::LayerType::Drill; }),
                 2);
        const model::Diagnostic* unknown = messageWith(**board, "nowhere.gbr");
        QVERIFY(unknown != nullptr);
        QCOMPARE(unknown->line, 7U);
        QCOMPARE(unknown->severity, model::Severity::Warning);
        QVERIFY(messageWith(**board, "Left out") != nullptr);
    }

    void aMapBesideTheJobIsUsed() {
        const Job job({{"one.gtl", kCopper}, {"two.gbl", kCopper}});
        QCOMPARE(model::gerber::layerMapBeside(job.path() + "/").string(), job.path("job.layers.txt"));
        job.write("job.layers.txt", "two.gbl = ignore\n");
        const auto board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(std::ranges::count_if((*board)->layers, &model::Layer::isCopper), 1);
        job.write("job.layers.txt", "nothing of use\n");
        const auto whole = job.open();
        QVERIFY(whole.ok());
        QCOMPARE(std::ranges::count_if((*whole)->layers, &model::Layer::isCopper), 2);
        QVERIFY(messageWith(**whole, "beside the job cannot be read") != nullptr);
    }

    void mapsThatCannotBeReadAreErrors() {
        const Job job({{"one.gtl", kCopper}});
        job.write("map.txt", "\x89PNG nonsense\n");
        for (const char* map : {"map.txt", "missing.txt"}) {
            const auto board = job.open(map);
            QVERIFY(!board.ok());
            QCOMPARE(board.error().code, base::ErrorCode::BadInput);
        }
        job.write("map.txt", "one.gtl = ignore\n");
        QVERIFY(!job.open("map.txt").ok());
    }

    void proposalsSayWhyAndWhetherTheyAreSure() {
        const Job job({{"b.gtl", kCopper},
                       {"b.g2", kCopper},
                       {"b.gbl", kCopper},
                       {"attribute.gbr", "%TF.FileFunction,Soldermask,Top*%\n" + kCopper},
                       {"paste_top.gbr", kCopper},
                       {"strange.gbr", kCopper},
                       {"b.drl", kDrills},
                       {"notes.txt", "read me\n"}});
        const std::vector<LayerProposal> proposals = job.propose();
        QCOMPARE(proposals.size(), std::size_t{8});
        QCOMPARE(wordsOf(proposals, "b.gtl"), std::string("copper top 1"));
        QCOMPARE(wordsOf(proposals, "b.g2"), std::string("copper inner 2"));
        QCOMPARE(wordsOf(proposals, "b.gbl"), std::string("copper bottom 3"));
        QCOMPARE(wordsOf(proposals, "attribute.gbr"), std::string("solder-mask top"));
        QCOMPARE(wordsOf(proposals, "paste_top.gbr"), std::string("paste top?"));
        QCOMPARE(wordsOf(proposals, "strange.gbr"), std::string("document?"));
        QCOMPARE(wordsOf(proposals, "b.drl"), std::string("drill"));
        QCOMPARE(proposals.back().path, std::string("notes.txt"));
        QVERIFY(!proposals.back().isImage());
        for (const LayerProposal& proposal : proposals) {
            QVERIFY(!proposal.why.empty());
            QCOMPARE(proposal.isImage(), !proposal.draws.empty());
        }
    }

    /// "power" is in all names: none of them is a power plane for it.
    void wordsThatAllImagesShareTellNoLayer() {
        const Job job({{"power-art.gtl", kCopper}, {"power-art.gbl", kCopper}, {"power-art.xyz", kCopper}});
        QCOMPARE(wordsOf(job.propose(), "power-art.xyz"), std::string("document?"));
        QCOMPARE(wordsOf(job.propose(), "power-art.gtl").substr(0, 10), std::string("copper top"));
        const Job planes({{"b.gtl", kCopper}, {"b-power.gbr", kCopper}, {"b.gbl", kCopper}});
        QCOMPARE(wordsOf(planes.propose(), "b-power.gbr").substr(0, 12), std::string("copper inner"));
        const Job numbered({{"layer_1.gbr", kCopper}, {"layer_2.gbr", kCopper}, {"layer_3.gbr", kCopper}});
        QCOMPARE(wordsOf(numbered.propose(), "layer_2.gbr").substr(0, 14), std::string("copper inner 2"));
    }

    void filesThatClaimOneLayerAreDoubted() {
        const Job job({{"b.gtl", kCopper}, {"b.top", kCopper}, {"b.gbl", kCopper}});
        const std::vector<LayerProposal> proposals = job.propose();
        QCOMPARE(wordsOf(proposals, "b.gtl").back(), '?');
        QCOMPARE(wordsOf(proposals, "b.top").back(), '?');
        QCOMPARE(wordsOf(proposals, "b.gbl"), std::string("copper bottom 3"));
        QVERIFY(proposals[0].why.find("same layer") != std::string::npos);
    }

    void innerCopperBehindAGapIsDoubted() {
        const Job job({{"b.gtl", kCopper}, {"b.g1", kCopper}, {"b.g3", kCopper}, {"b.gbl", kCopper}});
        const std::vector<LayerProposal> proposals = job.propose();
        QCOMPARE(wordsOf(proposals, "b.g1"), std::string("copper inner 2"));
        QCOMPARE(wordsOf(proposals, "b.g3"), std::string("copper inner 3?"));
        QVERIFY(proposals[2].why.find("number before it") != std::string::npos);
    }

    /// The map of the proposals opens the job as it would be without it.
    void theMapOfProposalsChangesNothing() {
        const Job job({{"b.gtl", kCopper},
                       {"b.g2", kCopper},
                       {"b.gbl", kCopper},
                       {"b.gko", kCopper},
                       {"b.gts", kCopper},
                       {"b.drl", kDrills}});
        const auto before = job.open();
        QVERIFY(before.ok());
        const LayerMap map = model::gerber::mapOf(job.propose());
        QVERIFY(model::gerber::writeLayerMap(job.path("map.txt"), map).ok());
        const auto after = job.open("map.txt");
        QVERIFY(after.ok());
        QCOMPARE((*after)->layers.size(), (*before)->layers.size());
        for (std::size_t i = 0; i < (*before)->layers.size(); ++i) {
            QCOMPARE((*after)->layers[i].type, (*before)->layers[i].type);
            QCOMPARE((*after)->layers[i].side, (*before)->layers[i].side);
        }
        const std::vector<LayerProposal> told = job.propose("map.txt");
        QCOMPARE(told[0].why, std::string("the layer map"));
        QVERIFY(std::ranges::all_of(told, &LayerProposal::isSure));
        const std::string text = model::gerber::explainedMapText(job.propose());
        QVERIFY(text.find("# its name, as of a known CAD system\nb.gtl = copper top 1\n") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(GerberLayerMapTest)
#include "gerber_layer_map_test.moc"
