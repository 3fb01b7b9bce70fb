// Everything of the core library; surpass/oracle.hpp and surpass/render.hpp are libraries of their
// own.
#pragma once

#include <surpass/context.hpp>
#include <surpass/curvature.hpp>
#include <surpass/evaluate.hpp>
#include <surpass/fairness.hpp>
#include <surpass/interpolate.hpp>
#include <surpass/io.hpp>
#include <surpass/mesh.hpp>
#include <surpass/quality.hpp>
#include <surpass/refiner.hpp>
#include <surpass/repair.hpp>
#include <surpass/requirements.hpp>
#include <surpass/result.hpp>
#include <surpass/scheme.hpp>
#include <surpass/similarity.hpp>
#include <surpass/topology.hpp>
#include <surpass/version.hpp>
