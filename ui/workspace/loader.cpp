#include "ui/workspace/loader.h"

#include <QElapsedTimer>
#include <utility>

#include "model/formats/registry.h"
#include "model/session/length_text.h"
#include "model/statistics/element_sizes.h"

namespace ui {

namespace session = model::session;

namespace {

using Thicknesses = std::vector<model::ThicknessOverride>;

base::Result<Thicknesses> parseAll(const std::vector<std::string>& texts, const model::Stackup& stackup) {
    Thicknesses all;
    for (const std::string& text : texts) {
        const base::Result<model::ThicknessOverride> one = session::parseOverride(text, stackup);
        if (!one) {
            return base::Error{one.error().code, "--set-thickness: " + one.error().text};
        }
        session::setThickness(all, *one);
    }
    return all;
}

/// Puts the document as its session and the request want it into `board`.
base::Status stack(const std::shared_ptr<const model::Document>& read, LoadedBoard& board) {
    const LoadRequest& request = board.request;
    session::LoadedSession found;
    if (!request.noSession) {
        found = session::loadSession(request.path, *read);
    }
    base::Result<Thicknesses> once = parseAll(request.thicknesses, read->stackup);
    if (!once) {
        return once.error();
    }
    board.thicknesses = {std::move(found.session.thicknesses), std::move(*once)};
    board.views = std::move(found.session.views);
    board.savedNets = std::move(found.session.nets);
    board.desk = std::move(found.session.desk);
    board.measurements = std::move(found.session.measurements);
    board.sections = std::move(found.session.sections);
    board.sessionNotes = std::move(found.ignored);
    board.document = session::applyThicknesses(read, board.thicknesses.all());
    return base::Done{};
}

}  // namespace

std::vector<model::ThicknessOverride> SetThicknesses::all() const {
    std::vector<model::ThicknessOverride> both = kept;
    for (const model::ThicknessOverride& change : once) {
        session::setThickness(both, change);
    }
    return both;
}

base::Result<LoadedBoard> loadBoard(const LoadRequest& request, base::Progress& progress) {
    QElapsedTimer clock;
    clock.start();
    const auto read = model::readBoard(request.path, {request.step, request.inferNets}, progress);
    if (!read) {
        return read.error();
    }
    LoadedBoard board;
    board.request = request;
    if (const base::Status stacked = stack(*read, board); !stacked) {
        return stacked.error();
    }
    auto boardModel = render::buildBoardModel(*board.document, {}, progress);
    if (!boardModel) {
        return boardModel.error();
    }
    board.model = std::make_shared<const render::BoardModel>(std::move(*boardModel));
    auto index = model::indexBoard(board.document, progress);
    if (!index) {
        return index.error();
    }
    board.index = *index;
    for (const model::Document* step : board.index->tree.steps) {
        auto nets = model::measureNets(*step, progress);
        if (!nets) {
            return nets.error();
        }
        board.nets.push_back(std::make_shared<const model::NetStatistics>(std::move(*nets)));
    }
    board.copperNm2 = model::copperAreas(*board.document);
    board.seconds = static_cast<double>(clock.elapsed()) / 1000.0;
    return board;
}

Loader::Loader(Work work, QObject* parent) : QObject(parent), m_work(std::move(work)) {
    connect(&m_load.background(), &Background::progressed, this, &Loader::progressed);
    connect(&m_load.background(), &Background::finished, this, &Loader::deliver);
}

void Loader::open(LoadRequest request) {
    cancel();
    m_request = std::move(request);
    m_load.ask([work = m_work, asked = m_request](base::Progress& progress) { return work(asked, progress); },
               "Opening", "There is not enough memory for this board");
    emit started(m_request);
}

void Loader::cancel() {
    if (isLoading()) {
        m_load.cancel();
        emit cancelled(m_request);
    }
}

void Loader::deliver() {
    const base::Result<LoadedBoard> result = m_load.take();
    if (result) {
        emit loaded(*result);
    } else if (result.error().code == base::ErrorCode::Cancelled) {
        emit cancelled(m_request);
    } else {
        emit failed(m_request, QString::fromStdString(result.error().text));
    }
}

}  // namespace ui
