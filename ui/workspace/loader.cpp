#include "ui/workspace/loader.h"

#include <QElapsedTimer>
#include <utility>

#include "model/index/pin_names.h"
#include "model/statistics/element_sizes.h"

namespace ui {

namespace {

std::vector<std::uint32_t> pinRanksOf(const model::Document& step) {
    std::vector<std::string> names(step.pins.size());
    for (std::size_t row = 0; row < names.size(); ++row) {
        names[row] = model::fullPinName(step, model::PinId{row});
    }
    return model::ranksOf(names);
}

}  // namespace

base::Result<LoadedBoard> loadBoard(const model::OpenRequest& request, base::Progress& progress) {
    QElapsedTimer clock;
    clock.start();
    ASSIGN_OR_RETURN(model::OpenedBoard opened, model::openBoard(request, progress));
    LoadedBoard board{std::move(opened)};
    if (!board.document) {
        return board;
    }
    ASSIGN_OR_RETURN(render::BoardModel boardModel, render::buildBoardModel(*board.document, {}, progress));
    board.model = std::make_shared<const render::BoardModel>(std::move(boardModel));
    ASSIGN_OR_RETURN(board.index, model::indexBoard(board.document, progress));
    for (const model::Document* step : board.index->tree.steps) {
        ASSIGN_OR_RETURN(model::NetStatistics nets, model::measureNets(*step, progress));
        board.nets.push_back(std::make_shared<const model::NetStatistics>(std::move(nets)));
        board.pinRanks.push_back(pinRanksOf(*step));
    }
    board.copperNm2 = model::copperAreas(*board.document);
    board.seconds = static_cast<double>(clock.elapsed()) / 1000.0;
    return board;
}

Loader::Loader(Work work, QObject* parent) : QObject(parent), m_work(std::move(work)) {
    connect(&m_load.background(), &Background::finished, this, &Loader::deliver);
    connect(&m_load.background(), &Background::cancelled, this, [this] { emit cancelled(m_request); });
}

void Loader::open(model::OpenRequest request) {
    cancel();
    m_request = std::move(request);
    m_load.run([work = m_work, wanted = m_request](base::Progress& progress) { return work(wanted, progress); },
               tr("Opening"), tr("There is not enough memory for this board"));
    emit started(m_request);
}

void Loader::deliver() {
    const base::Result<LoadedBoard> result = m_load.take();
    if (result && !result->document) {
        emit asked(m_request, result->forms);
    } else if (result) {
        emit loaded(*result);
    } else if (result.error().code == base::ErrorCode::Cancelled) {
        emit cancelled(m_request);
    } else {
        emit failed(m_request, QString::fromStdString(result.error().text));
    }
}

}  // namespace ui
