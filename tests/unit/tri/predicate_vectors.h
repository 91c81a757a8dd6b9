#pragma once

#include <array>
#include <random>
#include <vector>

#include "tri/predicates.h"

/// Questions to the predicates, the same for C++ and GLSL: full reach, ties, near ties and noise of every size.
namespace cases {

struct Question {
    std::array<base::Point, 4> points;
    std::array<std::uint32_t, 4> ids;
};

inline std::vector<Question> predicateQuestions() {
    constexpr int kReach = (1 << 30) + (1 << 28);
    std::mt19937 random(11);
    const auto below = [&](std::int64_t limit) { return static_cast<std::int64_t>(random()) % limit; };
    std::vector<Question> questions;
    const auto add = [&](std::array<base::Point, 4> points) {
        std::array<std::uint32_t, 4> ids{0, 1, 2, 3};
        std::ranges::shuffle(ids, random);
        questions.push_back({points, ids});
    };
    // Corners of the largest square and their neighbours: every carry and every sign.
    for (int i = 0; i < 2000; ++i) {
        std::array<base::Point, 4> points;
        for (base::Point& p : points) {
            const auto corner = [&] { return static_cast<int>((below(2) == 0 ? -1 : 1) * (kReach - below(3))); };
            p = {corner(), corner()};
        }
        add(points);
    }
    for (int i = 0; i < 4000; ++i) {
        const std::int64_t extent = std::int64_t{1} << (2 + below(29));
        std::array<base::Point, 4> points;
        for (base::Point& p : points) {
            p = {static_cast<int>(below(2 * extent) - extent), static_cast<int>(below(2 * extent) - extent)};
        }
        add(points);
    }
    // Four of the twelve points of a circle, large and small.
    constexpr base::Point kCircle[] = {{25, 0}, {24, 7}, {20, 15}, {15, 20}, {7, 24}, {0, 25}, {-7, 24}, {-20, -15}};
    for (int i = 0; i < 2000; ++i) {
        const int scale = 1 << below(25);
        std::array<base::Point, 4> points;
        for (base::Point& p : points) {
            const base::Point unit = kCircle[below(8)];
            p = {unit.x * scale + static_cast<int>(below(2)), unit.y * scale};
        }
        add(points);
    }
    return questions;
}

}  // namespace cases
