#include "viewpoints/looks.h"

#include <tbb/parallel_for.h>

#include <utility>

namespace viewcover {

std::optional<Candidate> Looks::look(const Look& job) const {
  if (limits_.due() || !views_.is_free(job.region, job.position)) return std::nullopt;
  Candidate candidate;
  candidate.viewpoint = {job.position, job.region};
  candidate.seen.resize(views_.matrix().bits.words_per_row());
  views_.look(job.region, job.position, candidate.seen, {}, job.target);
  candidate.seconds = limits_.seconds();
  return candidate;
}

std::vector<Candidate> Looks::from(std::span<const Look> jobs) {
  std::vector<std::optional<Candidate>> found(jobs.size());
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) { found[i] = look(jobs[i]); });
  limits_.expired();
  count(jobs.size());
  std::vector<Candidate> candidates;
  for (auto& candidate : found) {
    if (candidate) candidates.push_back(std::move(*candidate));
  }
  return candidates;
}

std::vector<Candidate> Looks::anneal(std::span<const AnnealingJob> jobs) {
  std::vector<std::vector<Candidate>> found(jobs.size());
  std::vector<std::size_t> evaluations(jobs.size());
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
    if (limits_.due()) return;
    const AnnealedPosition annealed =
        anneal_position(views_, jobs[i].region, *jobs[i].weights, jobs[i].options);
    evaluations[i] = annealed.evaluations;
    for (const Point& record : annealed.records) {
      if (auto candidate = look({jobs[i].region, record}))
        found[i].push_back(std::move(*candidate));
    }
  });
  limits_.expired();
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    count(evaluations[i]);
    for (Candidate& candidate : found[i]) candidates.push_back(std::move(candidate));
  }
  return candidates;
}

void Looks::count(std::uint64_t positions) {
  positions_ += positions;
  if (progress_ != nullptr) progress_->positions = positions_;
}

}  // namespace viewcover
