// One requirement of each kind on data/quad_torus.obj, as JSON.
#pragma once

#include <nlohmann/json.hpp>

namespace surpass::test {

inline const nlohmann::json kNormal = {{"vertex", 3}, {"normal", {0.1, 0.2, 1}}};
inline const nlohmann::json kPosition = {
    {"face", 5}, {"uv", {0.5, 0.25}}, {"position", {1, 0.5, 0.3}}};
inline const nlohmann::json kDirection = {
    {"face", 9}, {"uv", {0.1, 0.9}}, {"along", {1, 0}}, {"direction", {0, 0.5, 1}}};
inline const nlohmann::json kDerivative = {{"face", 7},
                                           {"uv", {0.25, 0.5}},
                                           {"corner", 2},
                                           {"along", {1, 0.5}},
                                           {"derivative", {0, 1, 0}}};
inline const nlohmann::json kRemove = {{"vertex", 12}, {"remove", true}};
inline const nlohmann::json kMoved = {{"vertex", 13}, {"position", {1, 1, 1}}};

}  // namespace surpass::test
