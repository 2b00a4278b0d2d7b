// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds/cloud_graph.h"
#include "meshes/mesh_distance.h"
#include "smoothing/smoothing_job.h"

#include <list>
#include <map>
#include <optional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** What the colours show. */
enum class Colouring
{
  DISPLACEMENT, //!< how far a point has moved
  CURVATURE,    //!< surface variation, 0 to 1/3
  DISTANCE      //!< to the mesh
};

/** A surface to draw: the finite points of a cloud, and their normals for shading. */
struct Surface
{
  core::Positions nodes;
  core::Vectors normals;

  /** In the cloud's unit. */
  Eigen::Vector3d
  position (std::size_t i) const
  {
    return nodes.unit * (nodes.base[i].cast<double> () + nodes.offset[i].cast<double> ());
  }
};

/** A cloud that is smoothed repeatedly. The neighbourhoods of the latest few values of k and radius are kept. */
class ViewerSession
{
public:
  /** \param[in] mesh_path the true surface; may be empty
    * \throw FileError, core::Error */
  ViewerSession (const std::string& cloud_path, const std::string& mesh_path);

  /** Smooths the cloud. \param[in] options of the method, by name
    * \throw UsageError, core::Error: nothing changes then */
  void
  smooth (const std::map<std::string, std::string>& options);

  const CloudFile&
  smoothedCloud () const
  {
    return result_;
  }

  const Surface&
  noisy () const
  {
    return noisy_;
  }

  const Surface&
  smoothed () const
  {
    return smoothed_;
  }

  /** Where the sensor stood, as the file says. */
  Eigen::Vector3d
  viewpoint () const
  {
    return file_.origin.head<3> ().cast<double> ();
  }

  /** Distance between neighbouring points. */
  double
  spacing () const
  {
    return spacing_;
  }

  /** What the last smoothing used, as options that reproduce it. */
  const std::string&
  parameters () const
  {
    return parameters_;
  }

  /** How long the last smoothing took, the search for neighbours included. */
  double
  seconds () const
  {
    return seconds_;
  }

  bool
  hasMesh () const
  {
    return mesh_distance_.has_value ();
  }

  /** Triangles between the nodes; empty unless the mesh has one vertex per point of the cloud. */
  const std::vector<Mesh::Triangle>&
  triangles () const
  {
    return triangles_;
  }

  /** One value per node of a surface of this session, in the cloud's unit if it is a length. Displacements are the same
    * for both surfaces. */
  std::vector<float>
  values (const Surface& surface, Colouring colouring) const;

private:
  std::vector<float>
  displacements () const;

  std::vector<float>
  curvatures (const Surface& surface) const;

  std::vector<float>
  distances (const Surface& surface) const;

  void
  useMesh (const std::string& path);

  Surface
  surfaceOf (const CloudFile& file) const;

  /** The neighbourhoods that the options ask for. */
  core::NeighborGraph::ConstPtr
  graphFor (const core::NeighborQuery& query, unsigned threads);

  struct KeptGraph
  {
    core::NeighborQuery query;
    core::NeighborGraph::ConstPtr graph;
  };

  CloudFile file_, result_;
  core::Positions cloud_;                       // of file_
  core::NeighborGraph::ConstPtr display_graph_; // for normals to shade by, and curvature
  Surface noisy_, smoothed_;
  std::list<KeptGraph> graphs_; // the latest first
  std::optional<MeshDistance> mesh_distance_;
  std::vector<Mesh::Triangle> triangles_;
  std::string parameters_;
  double spacing_ = 0;
  double seconds_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
