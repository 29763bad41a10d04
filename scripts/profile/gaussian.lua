-- Gaussian filter for profiles (ISO 16610-21) with the weights exp(-pi (x / (alpha cutoff))^2). Alpha is
-- chosen such that a wave with the length of the cut-off is reduced to half its amplitude.
--
-- Near the ends of a trace, some of the weights lie outside it. There, a line is fitted with the remaining
-- weights, and the value of the line is used (ISO 16610-28: moments of order 0 and 1 are preserved). A
-- straight line is unchanged everywhere.

local fft = require "archard.profile.fft"

local gaussian = { alpha = math.sqrt(math.log(2) / math.pi) }

local reach = 2 -- half the range of the weights, in cut-offs; omitted weights are below 1e-24 of the largest

-- Returns one-sided sums over the weights w at 0, 1, 2, ... steps as three lists: sums of w, of w u and of w
-- u^2, with u = x / (alpha cutoff). ratio: alpha cutoff / step.
local function one_sided(ratio, count)
  local s0, s1, s2 = { [0] = 1 / ratio }, { [0] = 0 }, { [0] = 0 }
  for i = 1, count do
    local u = i / ratio
    local w = math.exp(-math.pi * u * u) / ratio
    s0[i], s1[i], s2[i] = s0[i - 1] + w, s1[i - 1] + w * u, s2[i - 1] + w * u * u
  end
  return s0, s1, s2
end

-- Returns the Fourier transform of the sampled weights w (1 + i u) at the frequency f [1/step]. The transform
-- is real. Aliases larger than 1e-15 are included.
local function response(f, ratio)
  local sum, repeats = 0, ratio < 3 and 3 or 1
  for shift = -repeats, repeats do
    local g = (f + shift) * ratio
    sum = sum + math.exp(-math.pi * g * g) * (1 + g)
  end
  return sum
end

-- Returns two lists: the sums of w z and of w u z around each point. u increases towards smaller x.
local function weighted(z, ratio, steps)
  local count, re, im = 1, {}, {}
  while count < #z + steps do count = 2 * count end
  for i = 1, count do re[i], im[i] = z[i] or 0, 0 end
  fft(re, im, -1)
  for i = 1, count do
    local f = (i - 1) / count
    local r = response(f > 0.5 and f - 1 or f, ratio) / count
    re[i], im[i] = re[i] * r, im[i] * r
  end
  fft(re, im, 1)
  return re, im
end

-- Returns the long-wave part of heights at even steps, computed by two Fourier transforms.
function gaussian.long(z, step, cutoff)
  local count, ratio = #z, gaussian.alpha * cutoff / step
  local steps = math.ceil(reach * cutoff / step)
  local s0, s1, s2 = one_sided(ratio, math.min(steps, count))
  local sums, moments = weighted(z, ratio, steps)
  local most, result = #s0, {}
  for i = 1, count do
    local left, right = math.min(i - 1, most), math.min(count - i, most)
    local a, b, c = s0[left] + s0[right] - s0[0], s1[right] - s1[left], s2[left] + s2[right]
    result[i] = (c * sums[i] + b * moments[i]) / (a * c - b * b)
  end
  return result
end

-- Computes the effect of the filter on noise. Returns the fractions of the noise variance that remain in the
-- long and in the short waves, and the correlation length of the long waves. length: correlation length
-- before the filter (one step for white noise).
function gaussian.noise(length, is_white, cutoff)
  local own = math.sqrt(2) * gaussian.alpha * cutoff
  local squares = { is_white and 0 or length ^ 2, own ^ 2 }
  local new = math.max(length, math.sqrt(squares[1] + squares[2]))
  local long, mixed = length / new, math.min(1, length / math.sqrt(squares[1] + squares[2] / 2))
  return long, math.max(0, 1 - 2 * mixed + long), new
end

return gaussian
