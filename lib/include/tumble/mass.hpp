#pragma once
/// @file
/// Everything about mass properties: of meshes, closed forms, points and samples, and what to do
/// with them. For one thing alone, include its header.

/// @defgroup mass Mass properties
/// Everything about mass properties: of meshes, closed forms, points and samples, and what to do
/// with them. For one thing alone, include its header.

#include "tumble/mass/bounding_box.hpp"
#include "tumble/mass/column_mass_properties.hpp"
#include "tumble/mass/grid_points.hpp"
#include "tumble/mass/low_discrepancy_points.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/mirtich/mirtich.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/parts/diagnose.hpp"
#include "tumble/mass/parts/mass_properties.hpp"
#include "tumble/mass/point_sampling.hpp"
#include "tumble/mass/points.hpp"
#include "tumble/mass/principal_axes.hpp"
#include "tumble/mass/random_points.hpp"
#include "tumble/mass/replicated_sampling.hpp"
#include "tumble/mass/require_volume.hpp"
#include "tumble/mass/shell.hpp"
#include "tumble/mass/solids/ball.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/solids/capsule.hpp"
#include "tumble/mass/solids/cone.hpp"
#include "tumble/mass/solids/csg.hpp"
#include "tumble/mass/solids/cylinder.hpp"
#include "tumble/mass/solids/ellipsoid.hpp"
#include "tumble/mass/solids/placed.hpp"
#include "tumble/mass/stratified_points.hpp"
#include "tumble/mass/transform.hpp"
#include "tumble/mass/validity.hpp"

/// Solids made of solids, and what a solid is.
/// @ingroup mass
namespace tumble::solids {}

/// Mass properties from points and from columns.
/// @ingroup mass
namespace tumble::sampling {}

/// Thin shells: the mass lies in the surface.
/// @ingroup mass
namespace tumble::shells {}

/// Bodies made of several materials: what a file calls the faces of a mesh, a density for each
/// name, and the mass properties of each part and of the whole.
/// @ingroup mass
namespace tumble::parts {}

/// Boxes around points, and how they do for a body.
/// @ingroup mass
namespace tumble::boxes {}

/// Mirtich's integrals over a polyhedron: volume → faces → shadows → edges.
/// @ingroup mass
namespace tumble::mirtich {}
