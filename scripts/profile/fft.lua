-- Computes the discrete Fourier transform of 2^m complex numbers in place. Real and imaginary parts are two
-- lists.

-- Reorders the numbers: the bits of each index are reversed.
local function reorder(re, im, count)
  local j = 0
  for i = 0, count - 2 do
    if i < j then
      re[i + 1], re[j + 1] = re[j + 1], re[i + 1]
      im[i + 1], im[j + 1] = im[j + 1], im[i + 1]
    end
    local bit = count >> 1
    while j & bit ~= 0 do j, bit = j ~ bit, bit >> 1 end
    j = j | bit
  end
end

-- Returns the cosines and sines of the angles sign 2 pi k / count for k = 0 to count/2 - 1. Each value is
-- computed directly, so that rounding errors do not accumulate.
local function twiddles(count, sign)
  local c, s = {}, {}
  for i = 1, count // 2 do
    local angle = sign * 2 * math.pi * (i - 1) / count
    c[i], s[i] = math.cos(angle), math.sin(angle)
  end
  return c, s
end

-- Replaces the numbers by their transform: number k becomes the sum over j of (re + i im)[j] exp(sign 2 pi i
-- j k / count). sign: 1 or -1. Two transforms with opposite signs multiply the input by count.
return function(re, im, sign)
  local count = #re
  local cosines, sines = twiddles(count, sign)
  reorder(re, im, count)
  local half = 1
  while half < count do
    local stride = count // (2 * half)
    for first = 1, half do
      local c, s = cosines[(first - 1) * stride + 1], sines[(first - 1) * stride + 1]
      for i = first, count, 2 * half do
        local j = i + half
        local a, b = re[j], im[j]
        local x, y = a * c - b * s, a * s + b * c
        a, b = re[i], im[i]
        re[i], im[i], re[j], im[j] = a + x, b + y, a - x, b - y
      end
    end
    half = 2 * half
  end
end
