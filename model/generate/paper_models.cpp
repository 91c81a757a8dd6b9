#include "model/generate/paper_models.h"

#include <algorithm>

namespace model::generate {

namespace {

constexpr PaperModel kModels[] = {
    {"t1", {539, 0, 1395, 529, 823}, 3, 1'130'956},
    {"t2", {347, 132, 2457, 1126, 2964}, 3, 2'492'780},
    {"t3", {1455, 0, 14583, 1334, 2814}, 17, 10'579'900},
    {"t4", {1057, 0, 22505, 3140, 3740}, 26, 24'145'056},
    {"t5", {2401, 86, 33122, 2693, 5919}, 28, 27'670'832},
    {"t6", {7107, 332, 44168, 6542, 12601}, 25, 51'084'924},
    {"t7", {10801, 580, 92936, 3105, 6438}, 78, 79'204'340},
    {"t8", {28900, 0, 291660, 26680, 56280}, 15, 200'000'000},
    {"t9", {57800, 0, 583320, 53360, 112560}, 15, 400'000'000},
};

}  // namespace

std::span<const PaperModel> paperModels() {
    return kModels;
}

const PaperModel* findPaperModel(std::string_view name) {
    const auto found = std::ranges::find(kModels, name, &PaperModel::name);
    return found == std::end(kModels) ? nullptr : found;
}

}  // namespace model::generate
