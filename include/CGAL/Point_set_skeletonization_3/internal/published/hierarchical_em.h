// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_HIERARCHICAL_EM_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_HIERARCHICAL_EM_H


#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/sort_polled.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Point_search.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/Published_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/gaussian_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finalizer of the generator SplitMix64 (Steele et al. 2014): spreads every bit over all others.
inline std::uint64_t mixed(std::uint64_t h)
{
  h += 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
  return h ^ (h >> 31);
}

/// Returns random bits for a position, rounded to 2^-20 of the diagonal, which is finer than the
/// distances of components: a translated or scaled input, different in the last digits, draws the
/// same.
inline std::uint64_t position_hash(const Vector3& position, std::uint64_t seed)
{
  std::uint64_t h = mixed(seed);
  for(double x : {position.x(), position.y(), position.z()})
    h = mixed(h ^ static_cast<std::uint64_t>(std::llround(std::ldexp(x, 20))));
  return h;
}

/// Whether the component at `mean` becomes a parent: random, but determined by its position, so
/// that neither the order of the components nor the number of threads matters.
inline bool is_parent(const Vector3& mean, const Hierarchical_em_options& options,
                      std::size_t level)
{
  const std::uint64_t h = position_hash(mean, options.random_seed + level * 0x9E3779B97F4A7C15u);
  return std::ldexp(static_cast<double>(h >> 11), -53) < options.parent_probability;
}

/// Returns `mixture` in lexicographic order, with components of equal means merged: these draw the
/// same, so that duplicates would be all parents or all children. O(n log n).
inline Gaussians sorted_and_merged(Gaussians mixture)
{
  sort_polled(mixture.begin(), mixture.end(), [](const Gaussian& a, const Gaussian& b) {
    return lexicographically_less(a, b);
  });
  Gaussians result;
  result.reserve(mixture.size());
  for(std::size_t begin = 0, end; begin < mixture.size(); begin = end) {
    Progress::poll();
    end = begin + 1;
    while(end < mixture.size() && mixture[end].mean == mixture[begin].mean)
      ++end;
    if(end == begin + 1) {
      result.push_back(mixture[begin]); // same bits
      continue;
    }
    const Vector3 origin = mixture[begin].mean;
    Moments moments;
    for(std::size_t i = begin; i < end; ++i)
      moments.add(mixture[i].weight, mixture[i].mean - origin, mixture[i].covariance);
    result.push_back(moments.gaussian(origin));
  }
  return result;
}

/// One step of hierarchical expectation maximization from a fine mixture to a coarser one: the
/// components of the fine one are parents or children, and parents claim children.
class Em_step
{
  /// A child that a parent takes, its log-likelihood, and the share that the parent gets.
  struct Claim
  {
    std::size_t child;
    double log_likelihood;
    double responsibility;
  };

public:
  Em_step(const Gaussians& fine, const Hierarchical_em_options& options, std::size_t level)
    : alpha_(options.alpha)
  {
    for(const Gaussian& g : fine) {
      Progress::poll();
      (is_parent(g.mean, options, level) ? parents_ : children_).push_back(g);
    }
    claims_.resize(parents_.size());
    is_claimed_.assign(children_.size(), false);
  }

  Gaussians run(Concurrency concurrency)
  {
    claim_children(concurrency);
    Progress::poll();
    compute_responsibilities();
    Gaussians coarse = merged_families(concurrency);
    for(std::size_t c = 0; c < children_.size(); ++c)
      if(!is_claimed_[c])
        coarse.push_back(children_[c]);
    return coarse;
  }

private:
  void claim_children(Concurrency concurrency)
  {
    Progress::poll();
    const Point_search search(means_of(children_));
    log_determinants_.resize(children_.size());
    parallel_for(concurrency, children_.size(), [&](std::size_t c) {
      log_determinants_[c] = Precision(children_[c].covariance).log_determinant();
    });
    parallel_for(concurrency, parents_.size(), [&](std::size_t p) {
      std::vector<std::size_t> near;
      const double reach = alpha_ * largest_deviation(parents_[p].covariance);
      search.within(parents_[p].mean, reach, near);
      claims_[p] = claims(parents_[p], near);
    });
  }

  /// Claims of `parent` on those of the children `near` whose divergence from it,
  /// KL(child || parent) = (tr(S_p^-1 S_c) + d^T S_p^-1 d - 3 + ln(det S_p / det S_c)) / 2,
  /// is at most alpha^2 / 2.
  std::vector<Claim> claims(const Gaussian& parent, const std::vector<std::size_t>& near) const
  {
    std::vector<Claim> result;
    const Precision precision(parent.covariance);
    const double limit = alpha_ * alpha_;
    for(std::size_t c : near) {
      const Gaussian& child = children_[c];
      const double distance = precision.squared_length(child.mean - parent.mean);
      if(distance > limit) // the other terms of the divergence are not negative in sum
        continue;
      const double trace = trace_of_product(precision.inverse(), child.covariance);
      if(trace + distance - 3 + precision.log_determinant() - log_determinants_[c] > limit)
        continue;
      // ln of N(mu_c; mu_p, S_p) exp(-tr(S_p^-1 S_c) / 2), up to a constant common to all parents
      const double log_density = -(precision.log_determinant() + distance + trace) / 2;
      // A child represents `weight` points, and the prior of a parent is its weight.
      result.push_back({c, child.weight * log_density + std::log(parent.weight), 0});
    }
    return result;
  }

  /// Divides each child among the parents that claim it; relative to the likeliest one, as
  /// likelihoods underflow.
  void compute_responsibilities()
  {
    std::vector<double> largest(children_.size(), -std::numeric_limits<double>::infinity());
    for_each_claim([&](Claim& claim) {
      largest[claim.child] = (std::max)(largest[claim.child], claim.log_likelihood);
      is_claimed_[claim.child] = true;
    });
    std::vector<double> sum(children_.size(), 0);
    for_each_claim([&](Claim& claim) {
      claim.responsibility = std::exp(claim.log_likelihood - largest[claim.child]);
      sum[claim.child] += claim.responsibility;
    });
    for_each_claim([&](Claim& claim) { claim.responsibility /= sum[claim.child]; });
  }

  template <typename Function>
  void for_each_claim(const Function& function)
  {
    for(std::vector<Claim>& family : claims_)
      for(Claim& claim : family)
        function(claim);
  }

  /// Merges each parent with its shares of its children, by their moments.
  Gaussians merged_families(Concurrency concurrency) const
  {
    Gaussians result(parents_.size());
    parallel_for(concurrency, parents_.size(), [&](std::size_t p) {
      const Gaussian& parent = parents_[p];
      Moments moments; // about the parent's mean
      moments.add(parent.weight, Vector3::Zero(), parent.covariance);
      for(const Claim& claim : claims_[p]) {
        const Gaussian& child = children_[claim.child];
        moments.add(claim.responsibility * child.weight, child.mean - parent.mean,
                    child.covariance);
      }
      result[p] = moments.gaussian(parent.mean);
    });
    return result;
  }

  double alpha_;
  Gaussians parents_;
  Gaussians children_;
  std::vector<double> log_determinants_;   // of the children
  std::vector<std::vector<Claim>> claims_; // of each parent
  std::vector<bool> is_claimed_;
};

/// Returns the mixture one level above `fine`, in lexicographic order. It has the total weight,
/// mean and covariance of `fine`, and the same bits for any order of the components of `fine` and
/// any number of threads. O(n log n) in practice.
///
/// Vasconcelos and Lippman, Learning Mixture Hierarchies, NIPS 1998, regularised as by Preiner et
/// al., Continuous Projection for Fast L1 Reconstruction, SIGGRAPH 2014.
///
/// \param fine positive weights, positive definite covariances, normalised coordinates
/// \param level distinguishes the random choices of the levels
inline Gaussians coarser_em_level(const Gaussians& fine, const Hierarchical_em_options& options,
                                  std::size_t level, Concurrency concurrency)
{
  options.check();
  return sorted_and_merged(Em_step(sorted_and_merged(fine), options, level).run(concurrency));
}

/// Returns `finest`, followed by `options.number_of_levels` levels, each coarser than the one
/// before.
inline std::vector<Gaussians> hierarchical_em(Gaussians finest,
                                              const Hierarchical_em_options& options,
                                              Concurrency concurrency)
{
  std::vector<Gaussians> levels;
  levels.push_back(std::move(finest));
  for(std::size_t level = 1; level <= options.number_of_levels; ++level)
    levels.push_back(coarser_em_level(levels.back(), options, level, concurrency));
  return levels;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PUBLISHED_HIERARCHICAL_EM_H
